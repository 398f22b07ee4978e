#pragma once

#include <vector>

#include "collision_forge/base/geometry/polygon.h"

namespace forge {

/// m; edges are tested in equal pieces of at most this length.
inline constexpr double kEdgePiece = 0.5;
/// Returns the boundary lines of the union of `area` within `radius` (m) of any of `points` (m, the
/// frame of `area`), hole boundaries included. The rings of the polygons are tested in pieces of at
/// most kEdgePiece. A piece belongs to a line if its middle is within the radius and the union
/// covers the ground 5 cm beside the middle on exactly one side: a border between two adjoining
/// polygons is no boundary, and a line that enters another polygon is cut there, to kEdgePiece. A
/// piece that two polygons have in common (middles in the same cell of 1 cm) is returned once. Each
/// line has two or more points, in the order of its ring, and ends at the latest at the ring's
/// first point; a ring that is a boundary all around gives one line whose last point equals the
/// first. Returns no line if `area` or `points` is empty.
std::vector<std::vector<Vector2>> drivableEdges(const std::vector<Polygon>& area,
                                                const std::vector<Vector2>& points, double radius);

}  // namespace forge
