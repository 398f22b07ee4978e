#pragma once

#include <vector>

#include "collision_forge/base/geometry/polygon.h"

namespace forge {

/// Returns the boundary lines of the union of `area` within `radius` (m) of any of `points`: edges
/// with drivable ground on one side only, shared edges once. Edges are tested in pieces of
/// kEdgePiece, so lines that enter another polygon are cut to that accuracy. A closed line ends at
/// its first point.
inline constexpr double kEdgePiece = 0.5;  // m
std::vector<std::vector<Vector2>> drivableEdges(const std::vector<Polygon>& area,
                                                const std::vector<Vector2>& points, double radius);

}  // namespace forge
