#pragma once

#include <future>
#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "collision_forge/io/logs/log_source.h"

namespace forge {

/// The scenes of a log source, read on demand. Holds those used last: a list that is grouped by
/// scene reads each scene once. Thread-safe: different scenes are read at the same time, and a
/// thread that asks for a scene that another thread is reading waits for it.
class SceneSource {
 public:
  /// `scenes`: the wanted ones, all if empty; `kept`: how many are held at a time, at least 1.
  /// Throws as LogFormat::open().
  SceneSource(const LogSource& source, const std::vector<std::string>& scenes,
              const DataOptions& options, std::size_t kept, OnWarnings on_warnings = {},
              const NuScenesProgress& on_progress = {});

  /// Of the wanted scenes, in the source's order.
  std::vector<std::string> names() const { return reader_->names(); }

  /// Throws as SceneReader::read(), to every thread that waits for the scene; it is read again when
  /// it is asked for again.
  std::shared_ptr<const IndexedScene> at(const std::string& name);

 private:
  using ReadScene = std::shared_future<std::shared_ptr<const IndexedScene>>;

  ReadScene read(const std::string& name, std::unique_lock<std::mutex>& lock);

  std::unique_ptr<SceneReader> reader_;
  std::size_t kept_;
  std::mutex mutex_;
  std::list<std::pair<std::string, ReadScene>> scenes_;  // by name, used last first
};

}  // namespace forge
