#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace forge {

struct DispatchOptions {
  int jobs = 1;           ///< threads that work in this process; under mpirun in every rank
  std::size_t first = 0;  ///< items before it are left out: done in a run before
};

/// True on the one process that writes results (rank 0, or the only one). Under mpirun this starts
/// MPI; a process that asked and then ends without having come to dispatch() ends the whole run.
bool isMaster();

/// One thread a core; under mpirun one thread, because mpirun starts a rank a core.
int defaultJobs();

/// Deals the items [first, count) out dynamically to the threads of this process, or of all ranks
/// of mpirun, runs `work(index)` there, and hands the returned bytes to `take(index, bytes)` on the
/// master, in order of index, on the thread that called. `work` must be thread-safe and depend on
/// the index alone. Every rank must call it, but count and `first` are read on the master alone.
///
/// The master works too: dealing costs it microseconds an item, so a rank that only deals would
/// leave a core idle. Results that wait for an earlier one are bounded in number, so memory does
/// not grow with `count`.
///
/// An exception of `work` or `take` ends the run with that error on the master after all results
/// before it were taken; the other ranks return. What was thrown in another rank arrives as
/// std::runtime_error with the same text. A rank that dies takes the whole run with it: Open MPI
/// ends all ranks, and what was taken before stays taken. So does one that is silent, where
/// Ranks::watch() was called.
void dispatch(std::size_t count, const std::function<std::string(std::size_t)>& work,
              const std::function<void(std::size_t, const std::string&)>& take,
              const DispatchOptions& options);

}  // namespace forge
