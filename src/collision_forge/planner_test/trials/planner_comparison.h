#pragma once

#include <string>
#include <vector>

#include "collision_forge/planner_test/trials/planner_result.h"

namespace forge {

/// Results of one row name in two runs, over the cases that both runs tested.
struct RowComparison {
  std::string before;                  ///< rowName() in the first run
  std::string after;                   ///< rowName() in the second run
  int cases = 0;                       ///< number of cases tested in both runs
  std::vector<std::string> newly_hit;  ///< names of cases that the attacker hits in the second run
                                       ///< only, in order of the first run
  std::vector<std::string> newly_avoided;  ///< names of cases hit in the first run only; the second
                                           ///< may end in a failure or another contact
  /// Names of cases with a failure of the planner in the second run only
  std::vector<std::string> newly_failed;
  int still_hit = 0;  ///< number of cases hit in both runs
  /// Mean of nuPlan's score (NuplanScore::total) in the first run over these cases, failures
  /// included, 0 to 1.
  double score_before = 0.0;
  double score_after = 0.0;  ///< in the second run
};

/// Returns a comparison for each row name of both runs, sorted by name; if each run has one row
/// name, compares these two, whatever their names. Leaves out rows without a common tested case.
/// Throws std::invalid_argument if nothing is left.
std::vector<RowComparison> compareRuns(const std::vector<PlannerTestResult>& before,
                                       const std::vector<PlannerTestResult>& after);

/// Returns the comparison as Markdown: a table with a line per element ("planner", or "BEFORE ->
/// AFTER" if the names differ, "cases", "newly hit", "newly avoided", "still hit", "newly failed"
/// and both scores), then a list of case names for each element and kind of change that has any.
std::string comparisonText(const std::vector<RowComparison>& rows);

/// Returns the results in the file at `path`, or in results.jsonl if `path` is a folder of forge
/// test, in order, without motions (dropMotions()); empty for an empty file. Throws
/// std::runtime_error if the file cannot be read and JsonLineError, naming file and line, for a
/// line that is not a result.
std::vector<PlannerTestResult> readResults(const std::string& path);

}  // namespace forge
