#pragma once

#include "collision_forge/base/scene/collision_request.h"
#include "collision_forge/io/json/json_line.h"

namespace forge {

/// Writes the constraints of a request, beyond type, TTA and attacker, as fields of an object:
/// choice, believable, limits; attacker_class, manoeuvre, ego_side, impact_speed ({min, max}, m/s)
/// and overlap ({min, max}), null for any; turning, from_side and kRangeControls ({min, max}) only
/// if they differ from the defaults; alternatives. With `defaults`, writes only fields that
/// differ from the defaults or are not null.
void writeControls(JsonLineWriter& writer, const CollisionRequest& request,
                   const CrashDefinition* defaults = nullptr);

/// Reads the fields of writeControls(). If `may_lack`, fields may be absent: the request keeps its
/// values. Throws JsonLineError for an unknown word or a value out of range.
void readControls(JsonObject& object, CollisionRequest& request, bool may_lack);

}  // namespace forge
