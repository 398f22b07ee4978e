#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

namespace forge {

/// Pool of idle workers, which are costly to start. `Worker` has the constructor Worker(Options),
/// key(), a text that is equal for workers that can replace each other, and isUsable(), which is
/// false for a worker that has failed. Thread-safe.
template <class Worker, class Options>
class IdleWorkers {
 public:
  /// Removes an idle worker with this key (any one of several) from the pool and returns it, in the
  /// state in which it was given back; without one, returns a new Worker(options), whose key()
  /// should be `key`. Throws as the constructor. Never returns null.
  std::unique_ptr<Worker> take(const Options& options, const std::string& key) {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      const auto found = idle_.find(key);
      if (found != idle_.end()) {
        std::unique_ptr<Worker> worker = std::move(found->second);
        idle_.erase(found);
        return worker;
      }
    }
    return std::make_unique<Worker>(options);
  }

  /// Puts a worker (not null) into the pool; destroys one that is not usable.
  void giveBack(std::unique_ptr<Worker> worker) {
    if (!worker->isUsable()) return;
    const std::lock_guard<std::mutex> lock(mutex_);
    std::string key = worker->key();
    idle_.emplace(std::move(key), std::move(worker));
  }

 private:
  std::mutex mutex_;
  std::multimap<std::string, std::unique_ptr<Worker>> idle_;  // by key()
};

}  // namespace forge
