#pragma once

#include <vector>

#include "collision_forge/base/geometry/polygon.h"

namespace forge {

/// The lines at which drivable ground ends, as far as they are within `radius` metres of one of
/// `points`: the edges of the polygons with drivable ground to one side alone, an edge of several
/// once. A line is cut where it leads into another polygon, to `kEdgePiece`; one all the way around
/// ends where it begins.
inline constexpr double kEdgePiece = 0.5;  // m
std::vector<std::vector<Vector2>> drivableEdges(const std::vector<Polygon>& area,
                                                const std::vector<Vector2>& points, double radius);

}  // namespace forge
