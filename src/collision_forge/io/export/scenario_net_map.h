#pragma once

#include <cstddef>
#include <vector>

#include "collision_forge/base/map/lane_map.h"
#include "collision_forge/io/export/pickle_writer.h"

namespace forge {

/// Writes "map_features": lanes that have a centreline, with the links among them, walkways, and
/// the boundary lines `road_edges` of the drivable area. Returns the number of features.
std::size_t writeMapFeatures(PickleWriter& scenario, const LaneMap& map,
                             const std::vector<std::vector<Vector2>>& road_edges);

/// Writes map data that the format does not define: "driving_side" and "drivable_area".
void writeGround(PickleWriter& writer, const LaneMap& map);

}  // namespace forge
