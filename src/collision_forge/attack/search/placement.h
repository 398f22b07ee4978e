#pragma once

#include <vector>

#include "collision_forge/base/geometry/oriented_box.h"
#include "collision_forge/base/map/lane_map.h"
#include "collision_forge/base/scene/collision_request.h"

namespace forge {

/// A side of the ego's box that an attacker touches, and the sign of its heading.
struct Placement {
  Side side = Side::kLeft;
  double sign = 0.0;  ///< sign of the attacker's heading minus the ego's; 0: either
};

/// Returns the possible placements of a type, COLLIDE's own first:
/// - rear_end: behind the ego, or in front with the ego running into the attacker;
/// - opposite_direction: in front;
/// - lane_change: beside, heading towards the ego (from the left: sign -1);
/// - junction_crossing, angle types: beside or in front;
/// - sideswipe_same_direction: beside;
/// - ltap: the side from which an oncoming vehicle turns across the path (left in right-hand
///   traffic, right in left-hand traffic), or in front with the same sign; if the ego turns, the
///   other side and sign.
/// Throws std::invalid_argument for kAny.
std::vector<Placement> placementsOf(CollisionType type, DrivingSide driving_side,
                                    Turning turning = Turning::kAttacker);

/// Maximum contact position along a side, as a share of half the side from its middle.
inline constexpr double kMaxContactPosition = 0.9;

/// Returns the contact position on the ego's front (see attackerOffset()) of an impact location
/// (share of the ego's width, 0 at the left edge, see ContactConditions::impact_location).
inline double contactPositionOf(double impact_location) { return 1.0 - 2.0 * impact_location; }

/// rad; a heading band that ends within this of 0 or pi includes it.
inline constexpr double kBandEnd = 1e-3;

/// A touched side of the ego and the attacker's heading.
struct HeadedPlacement {
  Side side = Side::kLeft;
  double heading = 0.0;  ///< rad, attacker's heading minus the ego's, (-pi, pi]
};

/// Returns how a vehicle on a lane of `direction` (rad, relative to the ego's heading) can hit the
/// ego with the requested type: on each side of placementsOf(), the heading nearest to `direction`
/// within the type's band narrowed by `margin` (rad; not at ends that reach 0 or pi), if it differs
/// from `direction` by at most `max_lean` (rad). Leaves out sides and headings that contradict
/// `ego_side` or `from_side`. Positive headings come first, then in the order of placementsOf().
/// May be empty. Throws as request.bands() and placementsOf().
std::vector<HeadedPlacement> placementsAlong(double direction, const CollisionRequest& request,
                                             DrivingSide driving_side, double margin,
                                             double max_lean);

/// Returns the distance (m) along the unit vector `direction` (ego box's frame) by which the
/// attacker's box must move from `from` (attacker's box centre in the ego box's frame), where the
/// boxes overlap, until they only touch.
double partingDistance(const BoxSize& ego, const BoxSize& attacker, const Pose2& from,
                       const Vector2& direction);

/// Returns the attacker's box centre and heading in the ego box's frame when pushed in from `side`
/// (along the outward normal of that side, from outside) until the boxes overlap by `depth` m along
/// the push. `heading` in rad. `contact_position` in [-1, 1]: contact position along the side, as a
/// share of half the side (positive: forward; on front and rear: left).
Pose2 attackerOffset(const BoxSize& ego, const BoxSize& attacker, Side side, double heading,
                     double contact_position, double depth);

/// Returns the pose at the same heading, on the line through the ego's centre and the attacker's,
/// at which the boxes only touch. Poses are the attacker's box centre in the ego box's frame. An
/// attacker at the ego's centre is moved backwards along its heading.
Pose2 touchingOffset(const BoxSize& ego, const BoxSize& attacker, const Pose2& offset);

}  // namespace forge
