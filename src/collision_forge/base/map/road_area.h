#pragma once

#include <vector>

#include "collision_forge/base/map/lane_map.h"

namespace forge {

/// Returns the drivable area between recorded road edges (global map frame, m) as polygons with
/// holes, which may overlap; empty if `features` have no road edges. For maps without drivable
/// polygons, such as Waymo's maps. Reads the road edges, medians and driveways of `features` and
/// the centrelines of `lanes`.
///
/// - A road edge has its road on the side from which lane centrelines see it: a lane point votes
///   for its side of the nearest edge. An edge with votes for both sides has road on both; an edge
///   without votes follows the majority of all votes; without any vote, the road is on the left of
///   each edge, in the order of its points.
/// - A point is road if it is on the road side of the nearest edge, at most 25 m from it. Medians
///   and islands, whose road is outside, become holes.
/// - Edges may be open polylines in any order. An open end closer than 0.5 m to another continues
///   there; any other end is taken to continue straight for 3 m. No edge decides about points
///   beyond.
/// - Where no edge decides, or where a centreline is outside the result, the strip of kLaneWidth
///   along the centreline is added. Driveways of three points or more are added as they are.
///
/// The nearest edge is found on a grid of 0.5 m (coarser for maps larger than 2 km) and the border
/// is interpolated between its nodes: on smooth edges exact to a few centimetres; sharp corners are
/// cut by up to 0.2 m. Takes about 0.1 s for a Waymo scene.
std::vector<Polygon> roadArea(const std::vector<MapFeature>& features,
                              const std::vector<Lane>& lanes);

}  // namespace forge
