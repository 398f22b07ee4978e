#pragma once

#include <vector>

#include "collision_forge/base/geometry/oriented_box.h"

namespace forge {

/// A polygon with holes; rings are open (last point is not the first again), either orientation.
struct Polygon {
  std::vector<Vector2> exterior;
  std::vector<std::vector<Vector2>> holes;
};

/// True inside the exterior and outside every hole (even-odd rule).
bool contains(const Polygon& polygon, const Vector2& point);

/// The outline of a strip along a line, half of its width on either side.
std::vector<Vector2> stripAlong(const std::vector<Pose2>& line, double width);

}  // namespace forge
