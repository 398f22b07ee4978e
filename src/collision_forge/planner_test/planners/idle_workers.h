#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

namespace forge {

/// Pool of idle workers, which are costly to start. `Worker` has the constructor Worker(Options),
/// key() and isUsable(). Thread-safe.
template <class Worker, class Options>
class IdleWorkers {
 public:
  /// Returns an idle worker with this key, or starts one. Throws as the constructor.
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

  /// Returns a worker to the pool; one that is not usable is destroyed.
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
