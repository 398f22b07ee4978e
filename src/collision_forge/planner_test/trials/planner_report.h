#pragma once

#include <string>
#include <vector>

#include "collision_forge/planner_test/statistics/rate_table.h"
#include "collision_forge/planner_test/trials/planner_result.h"

namespace forge {

/// A table with the unit of its values.
struct PlannerTable {
  RateTable table;
  TableUnit unit;
};

/// Returns the tables of results with confidence intervals over scenes: one row for each of `rows`
/// (rowName(); and source, if there are several), one column per type. docs/planners.md defines
/// every measure. Untested cases are not counted; rollouts that ended with a planner failure count
/// only in the failure table.
std::vector<PlannerTable> plannerTables(const std::vector<PlannerTestResult>& results,
                                        const std::vector<std::string>& rows);

/// Returns Markdown lines with the number of tested cases and the statuses of the others.
std::string describeCases(const std::vector<PlannerTestResult>& results);

/// Identifies a rollout in a list of results.
struct WorstCase {
  std::size_t result = 0;  ///< index in the list
  std::string planner;
};

/// Returns, for each planner, the `count` most severe fair hits by the attacker
/// (PlannerRow::is_fair, isMoreSevere()), in descending order; at most one per scene.
std::vector<WorstCase> worstCases(const std::vector<PlannerTestResult>& results,
                                  const std::vector<std::string>& planners, std::size_t count);

}  // namespace forge
