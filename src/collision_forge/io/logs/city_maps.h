#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "collision_forge/base/map/lane_queries.h"
#include "collision_forge/io/logs/options.h"

namespace forge {

/// Receives warnings about a subject (a scene or a map). Called from any thread, one call at a
/// time; must not call back into the object that called it.
using OnWarnings =
    std::function<void(const std::string& subject, const std::vector<std::string>& warnings)>;

/// The maps of a nuScenes root, each read on first use and kept. Thread-safe; one map is read at a
/// time.
class CityMaps {
 public:
  /// `dataroot`: folder of a nuScenes root, with maps/expansion. Uses
  /// `options.conversion.centerline_resolution`, `options.input_limits` and `options.locations`.
  /// `on_warnings` (may be empty) receives the warnings about a map, with the subject "map CITY",
  /// when the map is read.
  CityMaps(const std::string& dataroot, const DataOptions& options, OnWarnings on_warnings = {});

  /// Returns the index of a city's map; `city`: LaneMap::location, as "boston-seaport". Throws as
  /// readNuScenesMap() and drivingSide(); the next call then tries again.
  std::shared_ptr<const LaneIndex> at(const std::string& city);

 private:
  std::string dataroot_;
  DataOptions options_;
  OnWarnings on_warnings_;
  std::mutex mutex_;
  std::map<std::string, std::shared_ptr<const LaneIndex>> maps_;  ///< by city; null after a failure
};

}  // namespace forge
