#pragma once

#include <memory>
#include <string>

#include "collision_forge/io/logs/log_source.h"
#include "collision_forge/ros/bags/topic_mapping.h"

namespace forge {

/// Options for reading bags of other sources.
struct ForeignBags {
  TopicMapping mapping;
  /// A file of nuScenes' map expansion, whose name is the location; empty: every bag has its lanes
  /// on /lane_map.
  std::string map;
};

/// Opens a bag or a folder of bags, each a scene read by readForeignBag(). Throws BagError without
/// a bag, std::runtime_error for a requested scene that does not exist. recording() throws as
/// readForeignBag(), readLaneMap() and readNuScenesMapFile() do, BagError for a bag without lanes,
/// and ConfigError for a location without a driving side.
std::unique_ptr<SceneReader> openForeignBags(const std::string& bags, ForeignBags how,
                                             SceneReading reading);

}  // namespace forge
