#pragma once

#include <vector>

#include "geometry/oriented_box.h"
#include "map/lane_map.h"
#include "scene/collision_request.h"

namespace forge {

/// From where the attacker's box is pushed against the ego's, in the ego box's frame.
enum class Side { kFront, kRear, kLeft, kRight };

/// The sides that a type can hit: rear_end the rear, opposite_direction the front, ltap the side
/// that an oncoming vehicle turns across from (the left in right-hand traffic, its mirror in
/// left-hand traffic), all others the left and the right (placements of COLLIDE).
std::vector<Side> sidesOf(CollisionType type, DrivingSide driving_side);

/// Heading of the attacker relative to the ego, radians, for a type's unsigned heading: an attacker
/// from the left heads to the right (negative), one from the right to the left.
double signedHeading(Side side, double heading);

/// Box middle and heading of the attacker in the ego box's frame such that, pushed in from `side`,
/// the boxes overlap by `depth` metres along the push. `slide` in [-1, 1] moves the attacker along
/// the side that is hit, as a share of half that side (positive is forward, or left for front and
/// rear).
Pose2 attackerOffset(const BoxSize& ego, const BoxSize& attacker, Side side, double heading,
                     double slide, double depth);

}  // namespace forge
