#pragma once

#include <string>
#include <vector>

#include "collision_forge/io/json/json_line.h"
#include "collision_forge/planner_test/trials/planner_result.h"

namespace forge {

/// Returns one line of results.jsonl without a line end, with the motions that the rows have; times
/// are relative to t0, as docs/planners.md defines.
std::string plannerResultLine(const PlannerTestResult& result);
/// Returns the result in such a line, with the motions that the line has (readDrive()). `where`:
/// "FILE: line N", for messages. Throws JsonLineError naming `where` for a line of another format
/// or version, or with a missing, unknown or malformed field.
PlannerTestResult readPlannerResultLine(const std::string& where, const std::string& line);

// Parts of the line, shared with other files.

/// Writes the fields of the line, except for format and version, into the open object.
void writePlannerResult(JsonLineWriter& writer, const PlannerTestResult& result);

/// Writes the summary as the object `key`.
void writeAvoidability(JsonLineWriter& writer, const char* key, const AvoidabilitySummary& summary);

/// Writes the fields of an element of "planners" without its motions (writeDrive()) into the open
/// object. `now`: t0, s, scene clock; times in the file are relative to it.
void writePlannerRow(JsonLineWriter& writer, const PlannerRow& row, double now);

/// Returns the header of results.csv, the column names separated by commas, without a line end.
/// Columns of the case and its avoidability ("name" to "last_start") come first, then planner,
/// background, attacker, evasive manoeuvre, "avoided_by" (drivers, separated by spaces), "fair",
/// "failure", contact, measures of the rollout, "nuplan_PART" (nuplanParts()) and "published_hit".
/// Units as in results.jsonl (docs/planners.md), but headings in degrees; flags are 1 or 0; an
/// empty column has no value, as the contact's without a contact.
std::string plannerResultCsvHeader();
/// Returns the lines of results.csv of a case, one per row in their order, without line ends. An
/// untested case without rows has one line, with name and status (and source, scene, type and tta
/// if it could be read); its other columns are empty. A row of an untested case adds planner and
/// "published_hit". A tested case without rows has no line.
std::vector<std::string> plannerResultCsvRows(const PlannerTestResult& result);

}  // namespace forge
