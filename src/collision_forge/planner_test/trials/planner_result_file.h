#pragma once

#include <string>
#include <vector>

#include "collision_forge/io/json/json_line.h"
#include "collision_forge/planner_test/trials/planner_result.h"

namespace forge {

/// Returns one line of results.jsonl without a line end; times are relative to t0, as
/// docs/planners.md defines.
std::string plannerResultLine(const PlannerTestResult& result);
/// Parses such a line. Throws JsonLineError naming `where`.
PlannerTestResult readPlannerResultLine(const std::string& where, const std::string& line);

// Parts of the line, shared with other files.

/// Writes the fields of the line, except for format and version, into the open object.
void writePlannerResult(JsonLineWriter& writer, const PlannerTestResult& result);

/// Writes the summary as the object `key`.
void writeAvoidability(JsonLineWriter& writer, const char* key, const AvoidabilitySummary& summary);

/// Writes the fields of an element of "planners" into the open object. `now`: s, scene clock.
void writePlannerRow(JsonLineWriter& writer, const PlannerRow& row, double now);

/// Header and lines of results.csv, one line per planner, without line ends.
std::string plannerResultCsvHeader();
std::vector<std::string> plannerResultCsvRows(const PlannerTestResult& result);

}  // namespace forge
