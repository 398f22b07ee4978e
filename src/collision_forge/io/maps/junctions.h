#pragma once

#include <vector>

#include "collision_forge/base/map/lane_map.h"

namespace forge {

/// Marks the lanes of junctions as connectors in an intersection, for maps that do not name them:
/// the lanes that cross another lane at more than 15 degrees, and the lanes that share a
/// predecessor or a successor with such a lane. Lanes on different levels count as crossing.
void markJunctions(std::vector<Lane>& lanes);

}  // namespace forge
