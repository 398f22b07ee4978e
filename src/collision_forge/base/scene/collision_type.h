#pragma once

#include <optional>
#include <string>
#include <vector>

namespace forge {

/// COLLIDE's five collision types (kLtap is a left turn across path); three types for the other
/// relative headings, named after the manners of collision of FARS and GES (NHTSA); and kAny, any
/// of these eight. config/crash_definition.yaml has the bands of relative heading that define each
/// type, contactFits() the relative positions.
enum class CollisionType {
  kLaneChange,
  kOppositeDirection,
  kRearEnd,
  kJunctionCrossing,
  kLtap,
  kSideswipeSameDirection,
  kAngleSameDirection,
  kAngleOppositeDirection,
  kAny,
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
