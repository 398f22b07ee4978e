#pragma once

#include <optional>
#include <string>

#include "collision_forge/base/scene/collision_request.h"

/// Names of request fields in files, messages and on the command line, if the type's own header
/// has none.
namespace forge {

/// Returns the names that collisionTypeFromString() accepts: "lane_change (LC), opposite_direction
/// (OD, HO, head_on), ...".
std::string collisionTypeWords();

/// Returns "drivable" or "strict".
const char* toString(LimitSet limits);
/// Returns the set of a name as toString() spells it; nullopt for another name.
std::optional<LimitSet> limitSetFromString(const std::string& name);

/// Returns the names of all manoeuvres of a collision type, separated by commas.
std::string manoeuvreNames(CollisionType type);

/// Returns the collision type to which a manoeuvre belongs.
CollisionType typeOf(Manoeuvre manoeuvre);

}  // namespace forge
