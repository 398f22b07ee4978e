#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "collision_forge/data/nuscenes_map.h"
#include "collision_forge/data/options.h"
#include "collision_forge/map/lane_queries.h"

namespace forge {

/// The maps of a nuScenes root, each read when it is first asked for. Thread-safe.
class CityMaps {
 public:
  /// Both must outlive it.
  CityMaps(const std::string& dataroot, const DataOptions& options)
      : dataroot_(dataroot), options_(options) {}

  /// Throws as readNuScenesMap() and drivingSide().
  std::shared_ptr<const LaneIndex> at(const std::string& city) {
    const std::lock_guard<std::mutex> lock(mutex_);
    std::shared_ptr<const LaneIndex>& lanes = maps_[city];
    if (!lanes) {
      lanes = std::make_shared<const LaneIndex>(std::make_shared<const LaneMap>(
          readNuScenesMap(dataroot_, city, drivingSide(options_, city),
                          {options_.conversion.centerline_resolution})));
    }
    return lanes;
  }

 private:
  const std::string& dataroot_;
  const DataOptions& options_;
  std::mutex mutex_;
  std::map<std::string, std::shared_ptr<const LaneIndex>> maps_;
};

}  // namespace forge
