#pragma once

#include <functional>
#include <vector>

#include "collision_forge/io/batch/run.h"
#include "collision_forge/planner_test/trials/planner_cases.h"
#include "collision_forge/planner_test/trials/planner_result_file.h"

namespace forge {

/// Tests every case in parallel. `run` has path, options and jobs; its file gets one line per case.
/// Returns the results in order, without motions (KeptDrives reads them from the file). A case that
/// cannot be read is kUnreadable. Throws as carryOut() and readPlannerResultLine(), and
/// std::runtime_error if the file has a line of another case.
std::vector<PlannerTestResult> testCases(
    Run run, const PlannerCases& cases,
    const std::function<PlannerTestResult(const PlannerCase&)>& test);

}  // namespace forge
