#pragma once

#include <optional>
#include <string>

#include "collision_forge/base/scene/collision_request.h"

/// The words by which files, messages and the command line name what a request asks for, where the
/// type's own header has none.
namespace forge {

/// The names that collisionTypeFromString() takes, as "lane_change (LC), opposite_direction (OD,
/// HO, head_on), ...".
std::string collisionTypeWords();

/// "drivable", "strict".
const char* toString(LimitSet limits);
std::optional<LimitSet> limitSetFromString(const std::string& name);

/// The names of all manoeuvres of a collision type, with commas between them.
std::string manoeuvreNames(CollisionType type);

/// The collision type that a manoeuvre leads to.
CollisionType typeOf(Manoeuvre manoeuvre);

}  // namespace forge
