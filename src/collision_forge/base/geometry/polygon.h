#pragma once

#include <vector>

#include "collision_forge/base/geometry/oriented_box.h"

namespace forge {

/// A polygon with holes. Rings are open (the last point does not repeat the first), of either
/// orientation. All points are in one frame, m.
struct Polygon {
  std::vector<Vector2> exterior;            ///< the outer ring
  std::vector<std::vector<Vector2>> holes;  ///< inner rings, within the exterior
};

/// Returns true if `point` is inside the exterior and outside every hole (even-odd rule); false for
/// an empty exterior. Points on an edge may count either way.
bool contains(const Polygon& polygon, const Vector2& point);

/// Returns the outline of a strip of `width` (m) centred on a line: left side forwards, right side
/// backwards, two points per pose, across its yaw; empty for an empty line.
std::vector<Vector2> stripAlong(const std::vector<Pose2>& line, double width);

}  // namespace forge
