#pragma once

#include <vector>

#include "collision_forge/base/geometry/polygon.h"

namespace forge {

/// m; edges are tested in pieces of this length.
inline constexpr double kEdgePiece = 0.5;
/// Returns the boundary lines of the union of `area` within `radius` (m) of any of `points` (m, the
/// frame of `area`): edges with drivable ground on one side only, shared edges once. Each line
/// follows the order of a polygon's ring. An edge is near if the middle of its piece is. Returns
/// none if `area` or `points` is empty. A line that enters another polygon is cut there, to
/// kEdgePiece. A closed line ends at its first point.
std::vector<std::vector<Vector2>> drivableEdges(const std::vector<Polygon>& area,
                                                const std::vector<Vector2>& points, double radius);

}  // namespace forge
