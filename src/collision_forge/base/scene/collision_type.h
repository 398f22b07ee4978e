#pragma once

#include <optional>
#include <string>
#include <vector>

namespace forge {

/// COLLIDE's five collision types; three types for the other relative headings, named after the
/// manners of collision of FARS and GES (NHTSA); and kAny. Degrees are the default bands of
/// |attacker's yaw - ego's yaw| at contact; config/crash_definition.yaml sets these bands and
/// the bands at t0, and contactFits() tests the relative positions. docs/protocols.md draws the
/// types.
enum class CollisionType {
  kLaneChange,         ///< the attacker, beside the ego, enters the ego's lane, 10 to 30 degrees
  kOppositeDirection,  ///< head-on: the attacker comes towards the ego, 170 to 180 degrees
  kRearEnd,            ///< front against rear, 0 to 10 degrees; either vehicle may be in front
  kJunctionCrossing,   ///< from the side at t0 (Turning::kEgo: from anywhere), 80 to 100 degrees
  /// Left turn across path (in left-hand traffic, a right turn), from opposite directions at t0:
  /// the attacker turns in front of the ego, 80 to 100 degrees, or with Turning::kEgo the ego turns
  /// in front of the attacker, 100 to 170 degrees.
  kLtap,
  kSideswipeSameDirection,  ///< flank against flank, 0 to 10 degrees
  /// The attacker turns into the ego's path or across it, or their roads cross at an acute angle,
  /// 30 to 80 degrees; at least one vehicle is touched on its flank.
  kAngleSameDirection,
  kAngleOppositeDirection,  ///< the attacker comes towards the ego at an angle, 100 to 170 degrees
  kAny,                     ///< in requests only: any of these eight
};

/// COLLIDE's five types, the default of all lists of types.
inline constexpr CollisionType kCollisionTypes[] = {
    CollisionType::kLaneChange, CollisionType::kOppositeDirection, CollisionType::kRearEnd,
    CollisionType::kJunctionCrossing, CollisionType::kLtap};

/// Returns true for the types of kCollisionTypes.
constexpr bool isPublished(CollisionType type) {
  for (const CollisionType published : kCollisionTypes) {
    if (type == published) return true;
  }
  return false;
}

/// All types of a contact: the five and the three others, without kAny.
inline constexpr CollisionType kAllCollisionTypes[] = {CollisionType::kLaneChange,
                                                       CollisionType::kOppositeDirection,
                                                       CollisionType::kRearEnd,
                                                       CollisionType::kJunctionCrossing,
                                                       CollisionType::kLtap,
                                                       CollisionType::kSideswipeSameDirection,
                                                       CollisionType::kAngleSameDirection,
                                                       CollisionType::kAngleOppositeDirection};

/// Returns "lane_change", "opposite_direction", "rear_end", "junction_crossing", "ltap",
/// "sideswipe_same_direction", "angle_same_direction", "angle_opposite_direction" or "any".
const char* toString(CollisionType type);
/// Returns the type of a name of toString(), of head_on, or of the short forms LC, OD, HO (opposite
/// direction), RE, JC and LTAP, ignoring case; nullopt for another name.
std::optional<CollisionType> collisionTypeFromString(const std::string& name);

/// Returns the types that a list of requests means by `type`: all types for kAny, else `type`.
std::vector<CollisionType> typesMeant(CollisionType type);

}  // namespace forge
