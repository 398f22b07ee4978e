#pragma once

#include <string>

#include "collision_forge/base/map/lane_map.h"
#include "collision_forge/io/logs/nuscenes_map_layers.h"
#include "collision_forge/io/logs/options.h"

namespace forge {

/// Numbers of pairs of neighbouring lanes of opposite direction in a map.
struct OppositeNeighbours {
  int to_the_left = 0;   ///< each lane is to the left of the other: traffic drives on the right
  int to_the_right = 0;  ///< each lane is to the right of the other: traffic drives on the left
};

/// Returns the driving side of a location: as configured in locations.yaml, else the side that most
/// of `pairs` show. Without any pair: the right side, and a warning.
DrivingSide drivingSide(const DataOptions& options, const std::string& location,
                        const OppositeNeighbours& pairs, WarningCounter& warnings);

}  // namespace forge
