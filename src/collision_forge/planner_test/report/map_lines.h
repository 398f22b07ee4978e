#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "collision_forge/base/geometry/pose2.h"

namespace forge {

/// The part of an open ring that is within the box (Sutherland-Hodgman). Parts that are apart are
/// joined along the box's border. Empty where nothing is inside.
std::vector<Vector2> clippedRing(std::vector<Vector2> ring, const Eigen::AlignedBox2d& box);

}  // namespace forge
