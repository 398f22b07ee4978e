#pragma once

#include <vector>

#include "collision_forge/base/geometry/pose2.h"

namespace forge {

/// Returns the line with as few of its points as keep every dropped point within `tolerance` metres
/// of it (Douglas and Peucker). Both ends are kept. A line with a point that is not finite is
/// returned as it is.
std::vector<Vector2> simplified(const std::vector<Vector2>& line, double tolerance);

}  // namespace forge
