#pragma once

#include "collision_forge/base/scene/attack.h"
#include "collision_forge/io/json/json_line.h"
#include "collision_forge/io/scenarios/motion_fields.h"

namespace forge {

/// Writes the object `key` (null: an element of an array) with the fields of a report, as
/// docs/scenarios.md defines them. Times are written in s from `now` (s, clock of the report). The
/// field `conditions` is written only if `has_conditions`, for requests that asksForConditions().
void writeCollisionReport(JsonLineWriter& writer, const char* key, const CollisionReport& report,
                          double now, bool has_conditions);
/// Reads an object of writeCollisionReport(). Throws JsonLineError, also for unknown words, a
/// number beyond the limits and fields that contradict each other.
CollisionReport readCollisionReport(JsonObject object, const LineContext& line);

}  // namespace forge
