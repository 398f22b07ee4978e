#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace forge {

/// How dispatch() distributes items.
struct DispatchOptions {
  int jobs = 1;           ///< number of threads, >= 1
  std::size_t first = 0;  ///< index of the first item; earlier ones were done in a previous run
};

/// Returns the number of cores, at least 1: one thread per core.
int defaultJobs();

/// Distributes the items [first, count) dynamically over threads. Calls `work(index)` once per item
/// on one of the threads, then `take(index, bytes)` with its result, in order of index, in the
/// calling thread. Returns when all results were taken. `work` must be thread-safe and depend on
/// the index alone. At most 64 items per thread are assigned and not yet taken, so memory does not
/// grow with `count`. Calls neither function if `options.first` >= `count`.
///
/// An exception of `work` or `take` is rethrown after the results of all earlier items were taken
/// and the threads have ended; later items may stay undone. Throws std::invalid_argument for jobs <
/// 1.
void dispatch(std::size_t count, const std::function<std::string(std::size_t)>& work,
              const std::function<void(std::size_t, const std::string&)>& take,
              const DispatchOptions& options);

}  // namespace forge
