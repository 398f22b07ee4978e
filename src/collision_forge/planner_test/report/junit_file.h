#pragma once

#include <string>
#include <vector>

#include "collision_forge/planner_test/trials/pass_criteria.h"

namespace forge {

/// Returns the results as JUnit XML, which CI systems show. Each name of `rows` (rowName()) is a
/// test suite, in the order of `rows`. A suite has:
/// - a test case per result: skipped if the case could not be tested, failed if failedBy() names a
/// criterion of `criteria`; its time is RolloutOutcome::duration, s;
/// - a test case "fails if CRITERION" per verdict of the row (judge()), failed if the verdict is.
std::string junitText(const std::vector<PlannerTestResult>& results,
                      const std::vector<Criterion>& criteria,
                      const std::vector<CriterionVerdict>& verdicts,
                      const std::vector<std::string>& rows);

}  // namespace forge
