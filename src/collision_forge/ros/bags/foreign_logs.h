#pragma once

#include <memory>
#include <string>

#include "collision_forge/io/logs/log_source.h"
#include "collision_forge/ros/bags/topic_mapping.h"

namespace forge {

/// Options for bags with foreign message types.
struct ForeignBags {
  TopicMapping mapping;
  /// Path of a map file, see readMapFile(); empty: each bag has its map on /lane_map.
  std::string map;
  bool without_lanes = false;  ///< each scene has a map without lanes; `map` must be empty
};

/// Opens the bag, or the folder of bags, at path `bags`: one scene per bag, named after its file,
/// (*.bag, without extension), read by readForeignBag() when asked for. `reading` selects the
/// scenes and gives the options of reading. A map file is read once, with the first scene. The
/// result is thread-safe. Throws BagError if there is no bag, std::runtime_error if a wanted scene
/// is missing. recording() and read() throw like readForeignBag(), readLaneMap(), readMapFile() and
/// keepWithin(), and BagError for a bag without a map if neither `map` nor `without_lanes` is set.
std::unique_ptr<SceneReader> openForeignBags(const std::string& bags, ForeignBags how,
                                             SceneReading reading);

}  // namespace forge
