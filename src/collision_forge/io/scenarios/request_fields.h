#pragma once

#include "collision_forge/base/scene/collision_request.h"
#include "collision_forge/io/json/json_line.h"

namespace forge {

/// What a request says beyond type, time and attacker, as fields of an object: choice, believable,
/// limits; attacker_class, manoeuvre, ego_side, impact_speed ({min, max}, m/s) and overlap ({min,
/// max}), null for anything; alternatives. With `defaults` only what is not as there, or not null.
void writeControls(JsonLineWriter& writer, const CollisionRequest& request,
                   const CrashDefinition* defaults = nullptr);

/// The opposite. With `may_lack` fields may be absent: the request keeps what it has. Throws
/// JsonLineError for a word or a value that does not exist.
void readControls(JsonObject& object, CollisionRequest& request, bool may_lack);

}  // namespace forge
