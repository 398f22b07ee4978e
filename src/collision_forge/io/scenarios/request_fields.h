#pragma once

#include "collision_forge/base/scene/collision_request.h"
#include "collision_forge/io/json/json_line.h"

namespace forge {

/// Writes the constraints of a request, beyond type, TTA and attacker, as fields of an object:
/// choice, believable, limits; attacker_class, manoeuvre, ego_side, impact_speed ({min, max}, m/s)
/// and overlap ({min, max}), null for any; turning, from_side, hidden_by and kRangeControls ({min,
/// max}) only if they differ from the defaults; alternatives. docs/scenarios.md has their words and
/// units. With `defaults` (not null), writes only fields that differ from the defaults (believable
/// and limits: from `defaults`) or are not null. An object must be open in `writer`.
void writeControls(JsonLineWriter& writer, const CollisionRequest& request,
                   const CrashDefinition* defaults = nullptr);

/// Reads the fields of writeControls() from `object` into `request`. If `may_lack`, any field may
/// be absent, else only the fields that writeControls() may leave out; `request` keeps its value
/// for an absent field and, unless it is a range, for null; null clears a range. Throws
/// JsonLineError for a missing field, an unknown word and a value of another type; whether ranges
/// make sense is not checked.
void readControls(JsonObject& object, CollisionRequest& request, bool may_lack);

}  // namespace forge
