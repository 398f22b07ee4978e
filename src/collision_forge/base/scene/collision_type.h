#pragma once

#include <optional>
#include <string>

namespace forge {

enum class CollisionType { kLaneChange, kOppositeDirection, kRearEnd, kJunctionCrossing, kLtap };

inline constexpr CollisionType kCollisionTypes[] = {
    CollisionType::kLaneChange, CollisionType::kOppositeDirection, CollisionType::kRearEnd,
    CollisionType::kJunctionCrossing, CollisionType::kLtap};

/// "lane_change", "opposite_direction", "rear_end", "junction_crossing" or "ltap".
const char* toString(CollisionType type);
/// Takes those names, head_on and the short ones (LC, OD, HO, RE, JC, LTAP), in any case.
std::optional<CollisionType> collisionTypeFromString(const std::string& name);

}  // namespace forge
