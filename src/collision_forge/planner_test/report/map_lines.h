#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "collision_forge/base/geometry/pose2.h"

namespace forge {

/// Returns the part of a ring inside the box of the same frame (Sutherland-Hodgman), as a ring;
/// separate parts are joined along the box's border. Rings are open: the first point is not
/// repeated at the end. Empty if no part is inside.
std::vector<Vector2> clippedRing(std::vector<Vector2> ring, const Eigen::AlignedBox2d& box);

}  // namespace forge
