#pragma once

#include <string>
#include <vector>

#include "collision_forge/base/map/lane_map.h"
#include "collision_forge/base/scene/input_limits.h"

namespace forge {

/// Removes speed limits, and lanes, areas and features with a point, beyond the limits; lanes only
/// if one is left. Links to removed lanes are removed, too. Appends to `warnings`, if given, one
/// line per kind with the number. checkMap() checks the other limits, such as the number of lanes.
void keepWithin(LaneMap& map, const InputLimits& limits,
                std::vector<std::string>* warnings = nullptr);

}  // namespace forge
