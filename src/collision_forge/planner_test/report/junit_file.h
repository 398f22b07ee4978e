#pragma once

#include <string>
#include <vector>

#include "collision_forge/planner_test/trials/pass_criteria.h"

namespace forge {

/// Returns the results as a whole JUnit XML document with its declaration, which CI systems show.
/// Each name of `rows` (rowName()) is a test suite, in the order of `rows`. A suite has:
/// - a test case per result, named as the result: skipped if the case could not be tested, failed
/// if failedBy() names a criterion of `criteria`; its time is RolloutOutcome::duration, s (0 if
/// skipped). A tested result without a row of the suite's name has no test case;
/// - a test case "fails if CRITERION" per verdict of the suite's name in `verdicts` (judge()),
/// failed if the verdict is; its time is 0.
std::string junitText(const std::vector<PlannerTestResult>& results,
                      const std::vector<Criterion>& criteria,
                      const std::vector<CriterionVerdict>& verdicts,
                      const std::vector<std::string>& rows);

}  // namespace forge
