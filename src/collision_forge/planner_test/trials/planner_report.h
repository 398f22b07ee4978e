#pragma once

#include <string>
#include <vector>

#include "collision_forge/planner_test/statistics/rate_table.h"
#include "collision_forge/planner_test/trials/planner_result.h"

namespace forge {

/// A table with the unit of its values.
struct PlannerTable {
  RateTable table;  ///< of one measure
  TableUnit unit;   ///< in which the table shows it
};

/// Returns the tables of results, one per measure, with confidence intervals over scenes. The
/// tables about rollouts come first and have one row for each of `rows` (rowName()) in their order;
/// the tables about cases have one row per condition. With several sources in the results, each row
/// is split into one per source, titled "ROW / SOURCE". The tables have one column per type and TTA
/// (groupTrials()). docs/planners.md defines every measure. Untested cases are not counted (except
/// unfit clips in "published_hit"); rollouts that ended with a planner failure count only in the
/// table "failure".
std::vector<PlannerTable> plannerTables(const std::vector<PlannerTestResult>& results,
                                        const std::vector<std::string>& rows);

/// Returns Markdown lines, with line ends: the number of all and of tested cases, then one line per
/// other status, by name, with its number of cases.
std::string describeCases(const std::vector<PlannerTestResult>& results);

/// Identifies a rollout in a list of results.
struct WorstCase {
  std::size_t result = 0;  ///< index in the list of results
  std::string planner;     ///< rowName() in that result
};

/// Returns, for each of `planners` (rowName()), one after the other, the `count` most severe fair
/// hits by the attacker (PlannerRow::is_fair, isMoreSevere()), in descending order, equally severe
/// ones in the order of `results`; at most one per scene, so there may be fewer. Rollouts with a
/// failure do not count.
std::vector<WorstCase> worstCases(const std::vector<PlannerTestResult>& results,
                                  const std::vector<std::string>& planners, std::size_t count);

}  // namespace forge
