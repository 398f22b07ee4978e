#pragma once

#include <functional>
#include <future>
#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "collision_forge/io/logs/log_source.h"

namespace forge {

/// Reads the scenes of a log source on demand and caches the most recently used: a list grouped by
/// scene reads each scene once. Thread-safe: different scenes are read concurrently, and threads
/// that request a scene that is being read wait for it.
class SceneSource {
 public:
  /// Opens the source. `scenes`: names of the selected scenes, empty: all; `kept`: number of cached
  /// scenes, at least 1 (not checked). `on_warnings` and `on_progress` as in SceneReading,
  /// `on_warnings` one call at a time. Throws as LogFormat::open().
  SceneSource(const LogSource& source, const std::vector<std::string>& scenes,
              const DataOptions& options, std::size_t kept, OnWarnings on_warnings = {},
              const NuScenesProgress& on_progress = {});

  /// Returns the names of the selected scenes, in the source's order.
  std::vector<std::string> names() const { return reader_->names(); }

  /// Returns a scene; it stays valid after it has left the cache. Throws as SceneReader::read(), in
  /// every thread that waits for the scene; the next call tries again.
  std::shared_ptr<const IndexedScene> at(const std::string& name);

  /// Passes each selected scene to `work`, in the source's order, on the caller's thread. A scene
  /// that cannot be read is left out; returns "NAME: REASON" for each such scene. Passes on what
  /// `work` throws.
  std::vector<std::string> forEach(const std::function<void(const IndexedScene&)>& work);

 private:
  using ReadScene = std::shared_future<std::shared_ptr<const IndexedScene>>;

  /// Reads a scene that is not cached; releases `lock`, of `mutex_`, while reading.
  ReadScene read(const std::string& name, std::unique_lock<std::mutex>& lock);

  std::unique_ptr<SceneReader> reader_;
  std::size_t kept_;
  std::mutex mutex_;
  std::list<std::pair<std::string, ReadScene>> scenes_;  // by name, most recently used first
};

/// Returns "; not read: PROBLEM" for each of `problems`, the result of SceneSource::forEach(),
/// joined, as the end of an error message; "" without problems.
std::string unreadableText(const std::vector<std::string>& problems);

}  // namespace forge
