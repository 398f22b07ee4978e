#pragma once

#include "collision_forge/io/json/json_line.h"
#include "collision_forge/planner_test/trials/planner_result.h"

namespace forge {

/// Writes the object "drive" of a row: the motions of its outcome and its evasive manoeuvre, as
/// docs/planners.md defines it; null for a row without motions. Writes reactive agents only if
/// there was a contact. `now`: s, scene clock.
void writeDrive(JsonLineWriter& writer, const PlannerRow& row, double now);

/// Reads that object into the row, whose other fields must have been read before. Agents and
/// attackers get ids and motions only. Throws JsonLineError.
void readDrive(JsonObject& object, PlannerRow& row, double now);

}  // namespace forge
