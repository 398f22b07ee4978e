#pragma once

#include <cstddef>
#include <vector>

#include "collision_forge/base/map/lane_map.h"
#include "collision_forge/io/export/pickle_writer.h"

namespace forge {

/// Writes the scenario's "map_features": lanes that have a centreline with the links among them,
/// walkways, and the lines at which drivable ground ends. Returns how many they are.
std::size_t writeMapFeatures(PickleWriter& scenario, const LaneMap& map,
                             const std::vector<std::vector<Vector2>>& road_edges);

/// Writes what the format has no word for: "driving_side" and "drivable_area".
void writeGround(PickleWriter& writer, const LaneMap& map);

}  // namespace forge
