#pragma once

#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "collision_forge/data/log_source.h"

namespace forge {

/// The scenes of a log source, read on demand. Holds those used last: a list that is grouped by
/// scene reads each scene once. Thread-safe.
class SceneSource {
 public:
  /// `scenes`: the wanted ones, all if empty; `kept`: how many are held at a time, at least 1.
  /// Throws as LogFormat::open().
  SceneSource(const LogSource& source, const std::vector<std::string>& scenes,
              const DataOptions& options, std::size_t kept, OnWarnings on_warnings = {},
              const NuScenesProgress& on_progress = {});

  /// Of the wanted scenes, in the source's order.
  std::vector<std::string> names() const { return reader_->names(); }

  /// Throws as SceneReader::read().
  std::shared_ptr<const IndexedScene> at(const std::string& name);

 private:
  std::unique_ptr<SceneReader> reader_;
  std::size_t kept_;
  std::mutex mutex_;
  std::list<std::shared_ptr<const IndexedScene>> scenes_;  // used last first
};

}  // namespace forge
