#pragma once

#include <string>
#include <vector>

#include "collision_forge/io/json/json_line.h"
#include "collision_forge/planner_test/trials/planner_result.h"

namespace forge {

/// One line of results.jsonl, without a line end; times from now, as docs/planners.md has it.
std::string plannerResultLine(const PlannerTestResult& result);
/// The opposite. Throws JsonLineError naming `where`.
PlannerTestResult readPlannerResultLine(const std::string& where, const std::string& line);

// Parts of the line, for files that hold the same.

void writeAvoidability(JsonLineWriter& writer, const char* key, const AvoidabilitySummary& summary);

/// The fields of an element of "planners", into the object that is open.
void writePlannerRow(JsonLineWriter& writer, const PlannerRow& row, double now);

/// A line a planner, without the line's end.
std::string plannerResultCsvHeader();
std::vector<std::string> plannerResultCsvRows(const PlannerTestResult& result);

}  // namespace forge
