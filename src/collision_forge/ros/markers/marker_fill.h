#pragma once

#include <vector>

#include "collision_forge/base/geometry/polygon.h"

namespace forge {

/// Triangles that cover a polygon without its holes, three counter-clockwise corners each. Cuts it
/// into trapezoids between the heights of its corners, so rings may be concave and of either
/// orientation (even-odd rule); they must not cross. Empty for a polygon that is not finite.
std::vector<Vector2> fillTriangles(const Polygon& polygon);

}  // namespace forge
