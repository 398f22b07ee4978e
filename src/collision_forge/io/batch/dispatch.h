#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace forge {

/// How dispatch() distributes items.
struct DispatchOptions {
  int jobs = 1;           ///< worker threads in this process; under mpirun in every rank
  std::size_t first = 0;  ///< index of the first item; earlier ones were done in a previous run
};

/// Returns true on the process that writes results (rank 0, or the only one). Under mpirun this
/// starts MPI; a process that calls it and exits without calling dispatch() ends the whole run.
bool isMaster();

/// Returns one thread per core; under mpirun one thread, because mpirun starts one rank per core.
int defaultJobs();

/// Distributes the items [first, count) dynamically over the threads of this process, or of all
/// ranks of mpirun. Calls `work(index)` on a worker thread of any rank, then `take(index, bytes)`
/// with its result on the master, in order of index, in the calling thread. `work` must be
/// thread-safe and depend on the index alone. Every rank must call it; count and `first` are used
/// on the master only.
///
/// The master also works: distributing costs it microseconds per item, so a rank for that alone
/// would leave a core idle. The number of results that wait for an earlier one is bounded, so
/// memory does not grow with `count`.
///
/// An exception of `work` or `take` is rethrown on the master after all earlier results were taken;
/// the other ranks return. An exception of another rank arrives as std::runtime_error with the same
/// text. If a rank dies, Open MPI ends all ranks; results taken before are kept. The same holds for
/// a rank that does not respond, after Ranks::watch(). Throws std::invalid_argument for jobs < 1.
void dispatch(std::size_t count, const std::function<std::string(std::size_t)>& work,
              const std::function<void(std::size_t, const std::string&)>& take,
              const DispatchOptions& options);

}  // namespace forge
