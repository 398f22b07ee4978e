#pragma once

#include <cstddef>
#include <vector>

#include "collision_forge/base/map/lane_map.h"
#include "collision_forge/base/scene/traffic_light.h"
#include "collision_forge/io/export/pickle_writer.h"

namespace forge {

/// Writes "map_features" into a scenario: lanes that have a centreline, with the links among them,
/// walkways, the map's features, and `road_edges`: boundary lines of the drivable area (m, map
/// frame), for a map without recorded road edges, else empty. Each lane with two or more poses in
/// its centreline, each walkway, each element of LaneMap::features and each line of `road_edges` is
/// one feature. Returns the number of features written.
std::size_t writeMapFeatures(PickleWriter& scenario, const LaneMap& map,
                             const std::vector<std::vector<Vector2>>& road_edges);

/// Writes "dynamic_map_states": for each light, its colour (colorAt()) at each of `times` (s,
/// ascending, on the clock of the lights), under the id of its lane.
void writeLights(PickleWriter& scenario, const std::vector<TrafficLight>& lights,
                 const std::vector<double>& times);

/// Writes the fields on lights of the metadata's "number_summary"; arguments as in writeLights().
/// num_traffic_lights: number of lights; num_traffic_light_types: the colours that occur, sorted;
/// num_traffic_light_each_step: for each colour, its number of rows, summed over all lights.
void writeLightNumbers(PickleWriter& metadata, const std::vector<TrafficLight>& lights,
                       const std::vector<double>& times);

/// Writes map data that the format does not define: "driving_side" ("right" or "left") and
/// "drivable_area", a list of dicts with "exterior" and "interiors" (areasOf() reads them).
void writeGround(PickleWriter& writer, const LaneMap& map);

}  // namespace forge
