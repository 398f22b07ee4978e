#pragma once

#include <functional>
#include <vector>

#include "collision_forge/io/batch/run.h"
#include "collision_forge/planner_test/trials/planner_cases.h"
#include "collision_forge/planner_test/trials/planner_result_file.h"

namespace forge {

/// Tests every case; the results without motions, which the file keeps (KeptDrives), in their order
/// on the master, none elsewhere. A case that cannot
/// be read is kUnreadable. `run`: path, options and jobs, a line a case. Throws as carryOut() and
/// readPlannerResultLine(), std::runtime_error for a line of another case.
std::vector<PlannerTestResult> testCases(
    Run run, const PlannerCases& cases,
    const std::function<PlannerTestResult(const PlannerCase&)>& test);

}  // namespace forge
