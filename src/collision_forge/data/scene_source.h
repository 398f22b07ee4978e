#pragma once

#include <functional>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "collision_forge/data/nuscenes_tables.h"
#include "collision_forge/data/options.h"
#include "collision_forge/scene/moment.h"

namespace forge {

/// Called with a subject and what is odd about it; on any thread, one at a time.
using OnWarnings =
    std::function<void(const std::string& subject, const std::vector<std::string>& warnings)>;

/// The names of all scenes of a root, in the table's order. Throws NuScenesError.
std::vector<std::string> readSceneNames(const std::string& dataroot, const std::string& version);

/// The scenes of a nuScenes root, put together on demand. Holds the tables of the wanted scenes in
/// short form, each map once, and the scenes used last: a list that is grouped by scene reads each
/// scene once. Thread-safe.
class SceneSource {
 public:
  /// `scenes`: the wanted ones, at least one; `kept`: how many are held at a time, at least 1.
  /// Throws NuScenesError as NuScenesRoot does.
  SceneSource(const std::string& dataroot, const std::string& version,
              const std::vector<std::string>& scenes, const DataOptions& options, std::size_t kept,
              OnWarnings on_warnings = {}, const NuScenesProgress& on_progress = {});

  /// Throws NuScenesError as readScene() and readNuScenesMap() do, ConfigError for a location
  /// without a driving side.
  std::shared_ptr<const IndexedScene> at(const std::string& name);

 private:
  std::shared_ptr<const IndexedScene> read(const std::string& name);
  const std::shared_ptr<const LaneIndex>& lanesOf(const std::string& location);
  void warn(const std::string& subject, const std::vector<std::string>& warnings) const;

  std::string dataroot_;
  DataOptions options_;
  NuScenesRoot root_;
  std::size_t kept_;
  OnWarnings on_warnings_;
  std::mutex mutex_;
  std::list<std::shared_ptr<const IndexedScene>> scenes_;  // used last first
  std::map<std::string, std::shared_ptr<const LaneIndex>> lanes_;
};

}  // namespace forge
