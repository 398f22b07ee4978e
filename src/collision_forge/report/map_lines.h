#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "collision_forge/geometry/pose2.h"

/// Lines of a map made shorter.
namespace forge {

/// The line with as few of its points as stay within `tolerance` metres of it (Douglas-Peucker);
/// both ends are kept.
std::vector<Vector2> simplified(const std::vector<Vector2>& line, double tolerance);

/// The part of an open ring that is within the box (Sutherland-Hodgman). Parts that are apart are
/// joined along the box's border. Empty where nothing is inside.
std::vector<Vector2> clippedRing(std::vector<Vector2> ring, const Eigen::AlignedBox2d& box);

}  // namespace forge
