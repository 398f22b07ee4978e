#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace forge {

struct DispatchOptions {
  int jobs = 1;  ///< threads in this process
};

/// True on the one process that writes results (rank 0, or the only one).
bool isMaster();

/// Deals the items [0, count) out dynamically to all ranks of mpirun (or to `jobs` threads of this
/// process without mpirun), runs `work(index)` there, and hands the returned bytes to `take(index,
/// bytes)` on the master, in order of index. `work` must be thread-safe and depend on the index
/// alone. An exception of `work` or `take` ends the run with that error after all results before it
/// were taken.
void dispatch(std::size_t count, const std::function<std::string(std::size_t)>& work,
              const std::function<void(std::size_t, const std::string&)>& take,
              const DispatchOptions& options);

}  // namespace forge
