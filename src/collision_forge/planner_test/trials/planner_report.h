#pragma once

#include <string>
#include <vector>

#include "collision_forge/planner_test/statistics/rate_table.h"
#include "collision_forge/planner_test/trials/planner_result.h"

namespace forge {

/// A table of planner tests with the unit of its values.
struct PlannerTable {
  RateTable table;
  TableUnit unit;
};

/// What results of planner tests say, with intervals over scenes: a row each of `rows` (rowName();
/// and source, where there are several), a column a type. docs/planners.md defines every measure.
/// Cases that were not tested count in no table, rollouts that a failure of the planner ended in
/// that of failures alone.
std::vector<PlannerTable> plannerTables(const std::vector<PlannerTestResult>& results,
                                        const std::vector<std::string>& rows);

/// How many cases were tested, and why the others were not; as Markdown lines.
std::string describeCases(const std::vector<PlannerTestResult>& results);

/// A rollout of a list of results.
struct WorstCase {
  std::size_t result = 0;  ///< index
  std::string planner;
};

/// Of each planner the `count` fair contacts (PlannerRow::is_fair) with the attacker of the highest
/// impact speed, worst first; at most one a scene.
std::vector<WorstCase> worstCases(const std::vector<PlannerTestResult>& results,
                                  const std::vector<std::string>& planners, std::size_t count);

}  // namespace forge
