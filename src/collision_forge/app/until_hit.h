#pragma once

#include <string>
#include <vector>

#include "collision_forge/planner_test/settings/config.h"
#include "collision_forge/planner_test/trials/kept_drives.h"
#include "collision_forge/planner_test/trials/request_cases.h"

namespace forge {

/// Reports the weaknesses of the planners (findWeaknesses()) in `results`, which were obtained on
/// `cases`; `drives` holds the driven motions. Prints the worst ones and writes to `folder` (throws
/// std::runtime_error if a file cannot be written):
/// - weaknesses.md: a table of all, worst first;
/// - weaknesses.jsonl: for each weakness its hardest collision, as a line of a scenario file;
/// - witnesses.jsonl: for each the evasive manoeuvre that proves it was avoidable;
/// - weaknesses/N.png, .gif and weaknesses/N_escape.png, .gif: pictures of both.
void reportWeaknesses(const RequestCases& cases, const std::vector<PlannerTestResult>& results,
                      const KeptDrives& drives, const std::string& folder, const Config& config);

}  // namespace forge
