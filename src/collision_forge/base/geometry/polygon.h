#pragma once

#include <vector>

#include "collision_forge/base/geometry/oriented_box.h"

namespace forge {

/// A polygon with holes. Rings are open (the last point does not repeat the first), of either
/// orientation.
struct Polygon {
  std::vector<Vector2> exterior;
  std::vector<std::vector<Vector2>> holes;
};

/// Returns true if `point` is inside the exterior and outside every hole (even-odd rule).
bool contains(const Polygon& polygon, const Vector2& point);

/// Returns the outline of a strip of `width` (m) centred on a line: left side forwards, right side
/// backwards.
std::vector<Vector2> stripAlong(const std::vector<Pose2>& line, double width);

}  // namespace forge
