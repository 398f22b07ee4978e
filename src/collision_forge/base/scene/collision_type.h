#pragma once

#include <optional>
#include <string>

namespace forge {

/// COLLIDE's collision types; kLtap is a left turn across path.
enum class CollisionType { kLaneChange, kOppositeDirection, kRearEnd, kJunctionCrossing, kLtap };

inline constexpr CollisionType kCollisionTypes[] = {
    CollisionType::kLaneChange, CollisionType::kOppositeDirection, CollisionType::kRearEnd,
    CollisionType::kJunctionCrossing, CollisionType::kLtap};

/// "lane_change", "opposite_direction", "rear_end", "junction_crossing" or "ltap".
const char* toString(CollisionType type);
/// Accepts the names above, head_on and LC, OD, HO, RE, JC, LTAP in any case; else nullopt.
std::optional<CollisionType> collisionTypeFromString(const std::string& name);

}  // namespace forge
