#pragma once

#include <string>
#include <vector>

#include "collision_forge/planner_test/trials/planner_result.h"

namespace forge {

/// Results of one row name in two runs, over the cases that both runs tested.
struct RowComparison {
  std::string before;                      ///< rowName() in the first run
  std::string after;                       ///< rowName() in the second run
  int cases = 0;                           ///< tested in both runs
  std::vector<std::string> newly_hit;      ///< names of cases, in order of the first run
  std::vector<std::string> newly_avoided;  ///< hit in the first run only
  std::vector<std::string> newly_failed;   ///< failure of the planner in the second run only
  int still_hit = 0;
  double score_before = 0.0;  ///< mean of nuPlan's score, 0 to 1
  double score_after = 0.0;
};

/// Compares rows of the same name; if each run has one row name, these two. Throws
/// std::invalid_argument if the runs share no case or no row name.
std::vector<RowComparison> compareRuns(const std::vector<PlannerTestResult>& before,
                                       const std::vector<PlannerTestResult>& after);

/// Returns the comparison as Markdown: a table of counts, then the names of the cases that changed.
std::string comparisonText(const std::vector<RowComparison>& rows);

/// Reads results.jsonl, or that file in a folder of forge test, without motions. Throws
/// std::runtime_error if it cannot be read and JsonLineError for a line that is not a result.
std::vector<PlannerTestResult> readResults(const std::string& path);

}  // namespace forge
