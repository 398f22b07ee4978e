#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>

#include "collision_forge/data/nuscenes_map.h"
#include "collision_forge/map/lane_queries.h"
#include "collision_forge/settings/config.h"

namespace forge {

/// The maps of a nuScenes root, each read when it is first asked for.
class LaneIndices {
 public:
  LaneIndices(std::string dataroot, const Config& config)
      : dataroot_(std::move(dataroot)), config_(config) {}

  /// Throws as readNuScenesMap() and drivingSide().
  const LaneIndex& at(const std::string& location) {
    const auto known = indices_.find(location);
    if (known != indices_.end()) return known->second;
    const auto map = std::make_shared<const LaneMap>(
        readNuScenesMap(dataroot_, location, drivingSide(config_, location),
                        {config_.conversion.centerline_resolution}));
    return indices_.try_emplace(location, map).first->second;
  }

 private:
  std::string dataroot_;
  const Config& config_;
  std::map<std::string, LaneIndex> indices_;
};

}  // namespace forge
