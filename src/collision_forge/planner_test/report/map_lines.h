#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "collision_forge/base/geometry/pose2.h"

namespace forge {

/// Returns the part of an open ring inside the box (Sutherland-Hodgman); separate parts are joined
/// along the box's border. Empty if nothing is inside.
std::vector<Vector2> clippedRing(std::vector<Vector2> ring, const Eigen::AlignedBox2d& box);

}  // namespace forge
