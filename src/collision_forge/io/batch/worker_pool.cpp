#include "collision_forge/io/batch/worker_pool.h"

#include <utility>

namespace forge {

WorkerPool::WorkerPool(int jobs, Work work) : work_(std::move(work)) {
  for (int i = 0; i < jobs; ++i) threads_.emplace_back([this] { run(); });
}

WorkerPool::~WorkerPool() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    is_closing_ = true;
  }
  given_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void WorkerPool::give(std::size_t index) {
  ++load_;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    items_.push_back(index);
  }
  given_.notify_one();
}

std::vector<ItemResult> WorkerPool::collect(std::chrono::milliseconds patience) {
  std::vector<ItemResult> results;
  std::unique_lock<std::mutex> lock(mutex_);
  finished_.wait_for(lock, patience, [this] { return !results_.empty(); });
  results.swap(results_);
  load_ -= results.size();
  return results;
}

void WorkerPool::run() {
  std::unique_lock<std::mutex> lock(mutex_);
  while (true) {
    given_.wait(lock, [this] { return is_closing_ || !items_.empty(); });
    if (is_closing_) return;
    const std::size_t index = items_.front();
    items_.pop_front();
    lock.unlock();
    ItemResult result = workOn(index);
    lock.lock();
    results_.push_back(std::move(result));
    finished_.notify_one();
  }
}

ItemResult WorkerPool::workOn(std::size_t index) const {
  try {
    return {index, work_(index), nullptr};
  } catch (...) {
    return {index, {}, std::current_exception()};
  }
}

}  // namespace forge
