#pragma once

#include <optional>
#include <string>
#include <vector>

namespace forge {

/// COLLIDE's five collision types (kLtap is a left turn across path); three types for the other
/// relative headings, named after the manners of collision of FARS and GES (NHTSA); and kAny, any
/// of these eight.
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

/// All types of a contact: the five and the three others, without kAny.
inline constexpr CollisionType kAllCollisionTypes[] = {CollisionType::kLaneChange,
                                                       CollisionType::kOppositeDirection,
                                                       CollisionType::kRearEnd,
                                                       CollisionType::kJunctionCrossing,
                                                       CollisionType::kLtap,
                                                       CollisionType::kSideswipeSameDirection,
                                                       CollisionType::kAngleSameDirection,
                                                       CollisionType::kAngleOppositeDirection};

/// "lane_change", "opposite_direction", "rear_end", "junction_crossing", "ltap",
/// "sideswipe_same_direction", "angle_same_direction", "angle_opposite_direction" or "any".
const char* toString(CollisionType type);
/// Accepts the names above, head_on and LC, OD, HO, RE, JC, LTAP in any case; else nullopt.
std::optional<CollisionType> collisionTypeFromString(const std::string& name);

/// Returns the types that a list of requests means by `type`: all types for kAny, else `type`.
std::vector<CollisionType> typesMeant(CollisionType type);

}  // namespace forge
