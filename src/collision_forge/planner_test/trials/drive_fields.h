#pragma once

#include "collision_forge/io/json/json_line.h"
#include "collision_forge/planner_test/trials/planner_result.h"

namespace forge {

/// Writes the object "drive" of a row: the motions of its outcome and of its escape, as
/// docs/planners.md has it; null for a row without motions. Reacting agents are written with a
/// contact only.
void writeDrive(JsonLineWriter& writer, const PlannerRow& row, double now);

/// Reads that object into the row, whose other fields must have been read. Agents and attackers
/// have ids and motions only. Throws JsonLineError.
void readDrive(JsonObject& object, PlannerRow& row, double now);

}  // namespace forge
