#pragma once

#include <vector>

#include "collision_forge/base/geometry/oriented_box.h"
#include "collision_forge/base/map/lane_map.h"
#include "collision_forge/base/scene/collision_request.h"

namespace forge {

/// The side of the ego's box that the attacker's is pushed against, and which way the attacker
/// heads there.
struct Placement {
  Side side = Side::kLeft;
  double sign = 0.0;  ///< of the attacker's heading relative to the ego's; 0: either
};

/// Where a type's attackers can stand. An attacker at the left heads to the right (sign -1), one at
/// the right to the left. rear_end: behind the ego, or ahead with the ego running into it.
/// opposite_direction: ahead. lane_change: beside. junction_crossing: beside or in front. ltap: the
/// side that an oncoming vehicle turns across from (the left in right-hand traffic, its mirror in
/// left-hand traffic), or in front, heading away from there. The first ones are COLLIDE's.
std::vector<Placement> placementsOf(CollisionType type, DrivingSide driving_side);

/// Of half a side: so far a place of contact may be from the side's middle, either way.
inline constexpr double kMaxSlide = 0.9;

/// A band of headings that ends so near to straight on or straight back reaches it, rad.
inline constexpr double kBandEnd = 1e-3;

/// The side of the ego's box that an attacker meets, and its heading relative to the ego's, rad.
struct HeadedPlacement {
  Side side = Side::kLeft;
  double heading = 0.0;
};

/// How who comes along a lane can meet the ego. `direction`: of the lane, relative to the ego's
/// heading, rad. The headings are those within the band, by `margin` (rad) but not where it reaches
/// straight on or back, that are nearest to it, to either side; none is more than `max_lean` (rad)
/// from it.
std::vector<HeadedPlacement> placementsAlong(double direction, CollisionType type,
                                             const TypeDefinition& band, DrivingSide driving_side,
                                             double margin, double max_lean);

/// How far along `direction` (a unit vector in the ego box's frame) the attacker's box can go from
/// `from` until the boxes, which overlap there, only just touch; metres.
double partingDistance(const BoxSize& ego, const BoxSize& attacker, const Pose2& from,
                       const Vector2& direction);

/// Box middle and heading of the attacker in the ego box's frame such that, pushed in from `side`,
/// the boxes overlap by `depth` metres along the push. `slide` in [-1, 1] moves the attacker along
/// the side that is hit, as a share of half that side (positive is forward, or left for front and
/// rear).
Pose2 attackerOffset(const BoxSize& ego, const BoxSize& attacker, Side side, double heading,
                     double slide, double depth);

/// The offset nearest to an attacker's along the line to the ego's middle at which the boxes only
/// just touch, at the same heading. An attacker in the very middle is where it comes from.
Pose2 touchingOffset(const BoxSize& ego, const BoxSize& attacker, const Pose2& offset);

}  // namespace forge
