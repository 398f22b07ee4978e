#pragma once

#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "collision_forge/data/city_maps.h"
#include "collision_forge/data/nuscenes_tables.h"
#include "collision_forge/data/options.h"
#include "collision_forge/scene/moment.h"

namespace forge {

/// The names of all scenes of a root, in the table's order. Throws NuScenesError.
std::vector<std::string> readSceneNames(const std::string& dataroot, const std::string& version);

/// The scenes of a nuScenes root, put together on demand. Holds the tables of the wanted scenes in
/// short form, each map once, and the scenes used last: a list that is grouped by scene reads each
/// scene once. Thread-safe.
class SceneSource {
 public:
  /// `scenes`: the wanted ones, all if empty; `kept`: how many are held at a time, at least 1.
  /// Throws NuScenesError as NuScenesRoot does.
  SceneSource(const std::string& dataroot, const std::string& version,
              const std::vector<std::string>& scenes, const DataOptions& options, std::size_t kept,
              OnWarnings on_warnings = {}, const NuScenesProgress& on_progress = {});

  /// Of the wanted scenes, in the table's order.
  std::vector<std::string> names() const { return root_.sceneNames(); }

  /// Throws NuScenesError as readScene() and readNuScenesMap() do, ConfigError for a location
  /// without a driving side.
  std::shared_ptr<const IndexedScene> at(const std::string& name);

 private:
  std::shared_ptr<const IndexedScene> read(const std::string& name);

  EgoVehicle ego_vehicle_;
  NuScenesRoot root_;
  std::size_t kept_;
  OnWarnings on_warnings_;
  CityMaps maps_;
  std::mutex mutex_;
  std::list<std::shared_ptr<const IndexedScene>> scenes_;  // used last first
};

}  // namespace forge
