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

/// Threads that work on items in the order in which they are given. For one thread that gives and
/// collects.
class WorkerPool {
 public:
  using Work = std::function<std::string(std::size_t)>;

  /// `work` is called on `jobs` (> 0) threads at once.
  WorkerPool(int jobs, Work work);
  /// Drops the items that no thread has begun, waits for the others and drops their results.
  ~WorkerPool();
  WorkerPool(const WorkerPool&) = delete;
  WorkerPool& operator=(const WorkerPool&) = delete;

  /// True while an item more keeps the threads busy: one a thread and one in reserve.
  bool wantsMore() const { return load_ <= threads_.size(); }
  void give(std::size_t index);

  /// What has been finished since the last call; waits at most `patience` for the first.
  std::vector<ItemResult> collect(std::chrono::milliseconds patience);

 private:
  void run();
  ItemResult workOn(std::size_t index) const;

  Work work_;
  std::size_t load_ = 0;  // given and not collected
  std::mutex mutex_;
  std::condition_variable given_;
  std::condition_variable finished_;
  std::deque<std::size_t> items_;
  std::vector<ItemResult> results_;
  bool is_closing_ = false;
  std::vector<std::thread> threads_;  // last: they use the members above
};

}  // namespace forge
