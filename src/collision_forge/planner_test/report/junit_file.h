#pragma once

#include <string>
#include <vector>

#include "collision_forge/planner_test/trials/pass_criteria.h"

namespace forge {

/// Returns the results as JUnit XML, which CI systems show: one test suite per row name with a test
/// case per tested case, which fails by failedBy(), and a test case per verdict of the row. Cases
/// that could not be tested are skipped.
std::string junitText(const std::vector<PlannerTestResult>& results,
                      const std::vector<Criterion>& criteria,
                      const std::vector<CriterionVerdict>& verdicts,
                      const std::vector<std::string>& rows);

}  // namespace forge
