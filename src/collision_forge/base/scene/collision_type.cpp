#include "collision_forge/base/scene/collision_type.h"

#include "collision_forge/base/scene/request_words.h"

namespace forge {
const char* toString(CollisionType type) {
  switch (type) {
    case CollisionType::kLaneChange:
      return "lane_change";
    case CollisionType::kOppositeDirection:
      return "opposite_direction";
    case CollisionType::kRearEnd:
      return "rear_end";
    case CollisionType::kJunctionCrossing:
      return "junction_crossing";
    case CollisionType::kLtap:
      return "ltap";
  }
  return "unknown";
}

std::optional<CollisionType> collisionTypeFromString(const std::string& name) {
  const std::string key = lowered(name);
  for (const CollisionType type : kCollisionTypes) {
    if (key == toString(type)) return type;
  }
  if (key == "lc") return CollisionType::kLaneChange;
  if (key == "od" || key == "ho" || key == "head_on") return CollisionType::kOppositeDirection;
  if (key == "re") return CollisionType::kRearEnd;
  if (key == "jc") return CollisionType::kJunctionCrossing;
  return std::nullopt;
}

}  // namespace forge
