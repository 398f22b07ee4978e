#pragma once

#include <optional>
#include <string>
#include <vector>

#include "collision_forge/base/scene/collision_request.h"

/// Names of request fields in files, messages and on the command line, if the type's own header
/// has none.
namespace forge {

/// Returns the names that collisionTypeFromString() accepts as one text for people: "lane_change
/// (LC), opposite_direction (OD, HO, head_on), ...".
std::string collisionTypeWords();

/// Returns "drivable" or "strict".
const char* toString(LimitSet limits);
/// Returns the set of a name as toString() spells it; nullopt for another name.
std::optional<LimitSet> limitSetFromString(const std::string& name);

/// Returns "attacker" or "ego".
const char* toString(Turning turning);
/// Returns the value of a name as toString() spells it; nullopt for another name.
std::optional<Turning> turningFromString(const std::string& name);

/// Sets the field of a request whose value is a word: type, choice, believable, limits,
/// attacker_class, manoeuvre, ego_side, turning, from_side, hidden_by or queue, named as in files
/// and messages. Words are spelled as in the type's FromString function, believable and queue
/// "true" or "false". Does not test whether the request as a whole is valid: from_side also accepts
/// "front" and "rear". Returns false, and leaves the request unchanged, for another field or an
/// unknown word.
bool setRequestWord(const std::string& field, const std::string& word, CollisionRequest& request);

/// Returns the manoeuvres with which an attack of this type can begin, in the order of kManoeuvres;
/// all for CollisionType::kAny. `turning` matters for kLtap only.
std::vector<Manoeuvre> manoeuvresOf(CollisionType type, Turning turning = Turning::kAttacker);

/// Returns true if manoeuvresOf(type, turning) has the manoeuvre.
bool isManoeuvreOf(Manoeuvre manoeuvre, CollisionType type, Turning turning = Turning::kAttacker);

/// Returns the names of manoeuvresOf(), separated by ", ".
std::string manoeuvreNames(CollisionType type, Turning turning = Turning::kAttacker);

/// Returns the first type of kAllCollisionTypes to which a manoeuvre belongs.
CollisionType typeOf(Manoeuvre manoeuvre);

}  // namespace forge
