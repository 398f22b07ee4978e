#pragma once

#include "collision_forge/io/json/json_line.h"
#include "collision_forge/planner_test/trials/planner_result.h"

namespace forge {

/// Writes the object "drive" of a row into the open object: the motions of its outcome and its
/// evasive manoeuvre, as docs/planners.md defines it; null for a row without motions. Writes other
/// agents only if there was a contact. Rounds poses, speeds and accelerations to 1e-6; leaves out
/// curvatures. `now`: t0, s, scene clock; times in the file are relative to it.
void writeDrive(JsonLineWriter& writer, const PlannerRow& row, double now);

/// Reads the object "drive" of `object` into the row, whose other fields must have been read
/// before; a null leaves the row without motions. Other agents get ids and motions only, the
/// attacker its motion only, without class and size; curvatures are 0. `now`: t0, s, scene clock.
/// Throws JsonLineError.
void readDrive(JsonObject& object, PlannerRow& row, double now);

}  // namespace forge
