#pragma once

#include <memory>
#include <string>

#include "collision_forge/io/logs/log_source.h"
#include "collision_forge/ros/bags/topic_mapping.h"

namespace forge {

/// How bags of others are read.
struct ForeignBags {
  TopicMapping mapping;
  /// A file of nuScenes' map expansion, whose name is the location; empty: every bag has its lanes
  /// on /lane_map.
  std::string map;
};

/// A bag or a folder of bags, one a scene, by readForeignBag(). Throws BagError where there is no
/// bag, std::runtime_error for a wanted scene that is not there. recording() throws as
/// readForeignBag(), readLaneMap() and readNuScenesMapFile() do, BagError for a bag without lanes,
/// and ConfigError for a location without a driving side.
std::unique_ptr<SceneReader> openForeignBags(const std::string& bags, ForeignBags how,
                                             SceneReading reading);

}  // namespace forge
