#pragma once

#include <vector>

#include "collision_forge/base/geometry/pose2.h"

namespace forge {

/// Returns the line simplified by the Douglas-Peucker algorithm: every dropped point is within
/// `tolerance` (m) of the result. Keeps both ends. Returns a line unchanged if it has fewer than
/// three points or a point that is not finite.
std::vector<Vector2> simplified(const std::vector<Vector2>& line, double tolerance);

}  // namespace forge
