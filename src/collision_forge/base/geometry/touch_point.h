#pragma once

#include "collision_forge/base/geometry/oriented_box.h"

namespace forge {

/// The middle of the contact of two boxes that just touch: the mean of those corners of either box
/// that are, to 5 cm, nearest to the other box.
Vector2 touchPoint(const OrientedBox& a, const OrientedBox& b);

}  // namespace forge
