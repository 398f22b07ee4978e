#pragma once

#include "collision_forge/base/geometry/oriented_box.h"

namespace forge {

/// Returns the contact point, in the frame of the boxes, of two boxes that just touch: the mean of
/// all corners of either box whose distance to the other box is within 5 cm of the smallest such
/// distance.
Vector2 touchPoint(const OrientedBox& a, const OrientedBox& b);

}  // namespace forge
