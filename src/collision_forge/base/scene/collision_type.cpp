#include "collision_forge/base/scene/collision_type.h"

#include <iterator>

#include "collision_forge/base/config/nearest_names.h"
#include "collision_forge/base/geometry/enum_words.h"

namespace forge {
namespace {

constexpr EnumWord<CollisionType> kWords[] = {
    {CollisionType::kLaneChange, "lane_change"},
    {CollisionType::kOppositeDirection, "opposite_direction"},
    {CollisionType::kRearEnd, "rear_end"},
    {CollisionType::kJunctionCrossing, "junction_crossing"},
    {CollisionType::kLtap, "ltap"},
    {CollisionType::kSideswipeSameDirection, "sideswipe_same_direction"},
    {CollisionType::kAngleSameDirection, "angle_same_direction"},
    {CollisionType::kAngleOppositeDirection, "angle_opposite_direction"},
    {CollisionType::kAny, "any"},
};

}  // namespace

const char* toString(CollisionType type) { return wordOf(kWords, type); }

std::optional<CollisionType> collisionTypeFromString(const std::string& name) {
  const std::string key = lowered(name);
  if (const auto type = valueOf(kWords, key)) return type;
  if (key == "lc") return CollisionType::kLaneChange;
  if (key == "od" || key == "ho" || key == "head_on") return CollisionType::kOppositeDirection;
  if (key == "re") return CollisionType::kRearEnd;
  if (key == "jc") return CollisionType::kJunctionCrossing;
  return std::nullopt;
}

std::vector<CollisionType> typesMeant(CollisionType type) {
  if (type != CollisionType::kAny) return {type};
  return {std::begin(kAllCollisionTypes), std::end(kAllCollisionTypes)};
}

}  // namespace forge
