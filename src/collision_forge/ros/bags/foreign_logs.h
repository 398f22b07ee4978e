#pragma once

#include <memory>
#include <string>

#include "collision_forge/io/logs/log_source.h"
#include "collision_forge/ros/bags/topic_mapping.h"

namespace forge {

/// Options for bags with foreign message types.
struct ForeignBags {
  TopicMapping mapping;
  /// Path of a file of nuScenes' map expansion, named after the location; empty: each bag has its
  /// map on /lane_map.
  std::string map;
};

/// Opens a bag or a folder of bags, one scene per bag, read by readForeignBag(). Throws BagError if
/// there is no bag, std::runtime_error if a wanted scene is missing. recording() throws like
/// readForeignBag(), readLaneMap() and readNuScenesMapFile(), BagError for a bag without lanes, and
/// ConfigError for a location without a driving side.
std::unique_ptr<SceneReader> openForeignBags(const std::string& bags, ForeignBags how,
                                             SceneReading reading);

}  // namespace forge
