#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "collision_forge/planner_test/trials/planner_result.h"

namespace forge {

/// Result of one row name (planner, attacker policy and background) over all tested cases.
struct PlannerSummary {
  /// A hit by the attacker.
  struct Impact {
    double speed = 0.0;     ///< m/s, PlannerContact::impact_speed
    std::string case_name;  ///< PlannerTestResult::name
  };

  std::string planner;  ///< rowName()
  int scenes = 0;       ///< number of distinct scenes of the cases
  int cases = 0;        ///< number of rollouts, failures included
  int hits = 0;         ///< rollouts whose first contact is with the attacker, without failures
  int avoidable = 0;    ///< hits that the planner could have avoided (PlannerRow::is_fair)
  int failures = 0;     ///< rollouts that ended with a planner failure
  /// The hit with the greatest speed, the first of equals; empty if there is none.
  std::optional<Impact> worst;
};

/// Returns one summary for each name of `rows` (rowName()), in their order; all numbers are 0 for a
/// name without rows.
std::vector<PlannerSummary> summarizePlanners(const std::vector<PlannerTestResult>& results,
                                              const std::vector<std::string>& rows);

/// Returns a line (with its line end) with the number of cases in which the verdict (hit by the
/// attacker, contact with another agent, failure or no contact) of a planner depends on the
/// background, in total and for each planner and policy; "" for a plan with one background.
std::string backgroundText(const std::vector<PlannerTestResult>& results, const TestPlan& plan);

/// Returns a table for a terminal: a title line ("planner", "scenes", "cases", "hit", "avoidable",
/// "failed", "ms a call", "worst impact" with its case), then one line per summary. `milliseconds`:
/// mean computing time of a call of plan(), ms, by row name; "-" if a row is missing in it.
std::string summaryText(const std::vector<PlannerSummary>& summaries,
                        const std::map<std::string, double>& milliseconds);

}  // namespace forge
