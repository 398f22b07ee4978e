#pragma once

#include <string>

#include "collision_forge/base/map/lane_map.h"
#include "collision_forge/io/logs/nuscenes_map_layers.h"
#include "collision_forge/io/logs/options.h"

namespace forge {

/// Numbers of pairs of neighbouring lanes of opposite direction in a map.
struct OppositeNeighbours {
  /// Each lane of such a pair is to the left of the other: traffic drives on the right.
  int to_the_left = 0;
  /// Each lane of such a pair is to the right of the other: traffic drives on the left.
  int to_the_right = 0;
};

/// Returns the driving side of a location (LaneMap::location): as configured in locations.yaml,
/// else the side that most of `pairs` show. If both numbers are equal, for instance 0: the right
/// side, and a warning.
DrivingSide drivingSide(const DataOptions& options, const std::string& location,
                        const OppositeNeighbours& pairs, WarningCounter& warnings);

}  // namespace forge
