#pragma once

#include <string>
#include <vector>

#include "collision_forge/data/json_line.h"
#include "collision_forge/trials/planner_result.h"

namespace forge {

/// The object "contact" of a row: `t` in s from now, angles in rad, speeds in m/s; `type` is null
/// where the contact is of none.
void writeContact(JsonLineWriter& writer, const PlannerContact& contact, double now);

/// One line of results.jsonl, without a line end; times from now, as docs/planners.md has it.
std::string plannerResultLine(const PlannerTestResult& result);
/// The opposite. Throws JsonLineError naming `where`.
PlannerTestResult readPlannerResultLine(const std::string& where, const std::string& line);

/// A line a planner, without the line's end.
std::string plannerResultCsvHeader();
std::vector<std::string> plannerResultCsvRows(const PlannerTestResult& result);

}  // namespace forge
