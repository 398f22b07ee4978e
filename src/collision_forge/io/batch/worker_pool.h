#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "collision_forge/io/batch/ledger.h"

namespace forge {

/// A pool of threads that work on items in the order given. All functions must be called from one
/// thread.
class WorkerPool {
 public:
  /// Returns the result of the item with this index.
  using Work = std::function<std::string(std::size_t)>;

  /// Starts `jobs` (> 0) threads, which call `work` concurrently. Exceptions of `work` are returned
  /// by collect().
  WorkerPool(int jobs, Work work);
  /// Drops items that no thread has begun, waits for the rest and drops their results.
  ~WorkerPool();
  WorkerPool(const WorkerPool&) = delete;
  WorkerPool& operator=(const WorkerPool&) = delete;

  /// Returns true if the pool holds at most as many items as threads, so that one item beyond the
  /// items in work is in reserve. Items count from give() to collect().
  bool wantsMore() const { return load_ <= threads_.size(); }
  /// Adds an item for the next free thread.
  void give(std::size_t index);

  /// Returns the results finished since the last call, in the order in which they finished; waits
  /// at most `patience` for the first. Returns none if none finished in that time.
  std::vector<ItemResult> collect(std::chrono::milliseconds patience);

 private:
  /// Loop of each thread.
  void run();
  /// Calls `work_` and catches its exception.
  ItemResult workOn(std::size_t index) const;

  Work work_;
  std::size_t load_ = 0;  // items given and not collected
  std::mutex mutex_;
  std::condition_variable given_;
  std::condition_variable finished_;
  std::deque<std::size_t> items_;    // given, not begun
  std::vector<ItemResult> results_;  // finished, not collected
  bool is_closing_ = false;
  std::vector<std::thread> threads_;  // last: they use the members above
};

}  // namespace forge
