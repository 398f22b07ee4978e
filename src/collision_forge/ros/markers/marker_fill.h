#pragma once

#include <vector>

#include "collision_forge/base/geometry/polygon.h"

namespace forge {

/// Triangulates a polygon with holes; returns three counter-clockwise corners per triangle, in the
/// polygon's frame and unit. Cuts the polygon into trapezoids between the y values of its corners:
/// rings may be concave and of either orientation (even-odd rule), open or closed, but must not
/// cross. Returns no triangles for a polygon without area or with a corner that is not finite.
std::vector<Vector2> fillTriangles(const Polygon& polygon);

}  // namespace forge
