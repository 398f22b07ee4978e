#pragma once

#include <string>

#include "collision_forge/base/map/lane_map.h"
#include "collision_forge/io/logs/nuscenes_map_layers.h"
#include "collision_forge/io/logs/options.h"

namespace forge {

/// The pairs of neighbouring lanes of opposite direction in a map. With traffic on the right, each
/// lane of such a pair is to the left of the other.
struct OppositeNeighbours {
  int to_the_left = 0;
  int to_the_right = 0;
};

/// Returns the driving side of a location: as configured in locations.yaml, else from most of its
/// pairs of lanes. Without any pair: the right side, and a warning.
DrivingSide drivingSide(const DataOptions& options, const std::string& location,
                        const OppositeNeighbours& pairs, WarningCounter& warnings);

}  // namespace forge
