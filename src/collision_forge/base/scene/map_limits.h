#pragma once

#include <string>
#include <vector>

#include "collision_forge/base/map/lane_map.h"
#include "collision_forge/base/scene/input_limits.h"

namespace forge {

/// Removes speed limits above max_speed or below 0; lanes, areas and features with a point beyond
/// max_coordinate; and lanes with a centreline of more than max_points. Keeps all lanes if every
/// lane would be removed. Removes links to removed lanes, too. Appends to `warnings`, if given, one
/// line per kind of removed element with the number. checkMap() checks the other limits, such as
/// the number of lanes.
void keepWithin(LaneMap& map, const InputLimits& limits,
                std::vector<std::string>* warnings = nullptr);

}  // namespace forge
