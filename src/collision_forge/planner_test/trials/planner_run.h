#pragma once

#include <functional>
#include <vector>

#include "collision_forge/io/batch/run.h"
#include "collision_forge/planner_test/trials/planner_cases.h"
#include "collision_forge/planner_test/trials/planner_result_file.h"

namespace forge {

/// Tests every case in parallel. The caller sets path, options, layout and jobs of `run`; its file
/// gets one line per case (plannerResultLine()), and an interrupted run is resumed. `test`: returns
/// the result of one case; called once per missing case, on worker threads, and must be
/// thread-safe. Returns the results in order of the cases, without motions (KeptDrives reads them
/// from the file). A case that cannot be read is kUnreadable. Throws as carryOut() and
/// readPlannerResultLine(), and std::runtime_error if the file has a line of another case.
std::vector<PlannerTestResult> testCases(
    Run run, const PlannerCases& cases,
    const std::function<PlannerTestResult(const PlannerCase&)>& test);

}  // namespace forge
