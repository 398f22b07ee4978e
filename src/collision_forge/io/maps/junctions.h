#pragma once

#include <vector>

#include "collision_forge/base/map/lane_map.h"

namespace forge {

/// Marks the lanes of junctions as connectors in an intersection (Lane::is_connector,
/// Lane::is_intersection), for maps that do not name them: the lanes whose centrelines cross the
/// centreline of another lane at more than 15 degrees, and the lanes that share a predecessor or a
/// successor with such a lane. Lanes on different levels count as crossing. Links must be mutual
/// and refer to `lanes`.
void markJunctions(std::vector<Lane>& lanes);

}  // namespace forge
