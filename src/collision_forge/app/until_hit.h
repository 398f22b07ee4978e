#pragma once

#include <string>
#include <vector>

#include "collision_forge/planner_test/settings/config.h"
#include "collision_forge/planner_test/trials/kept_drives.h"
#include "collision_forge/planner_test/trials/request_cases.h"

namespace forge {

/// What the results over `cases` say of the planners' weaknesses (findWeaknesses()), the worst
/// first; `drives` has their motions. Prints the first few and writes a table of all to
/// FOLDER/weaknesses.md; of each weakness its hardest hit: a line of a scenario file in
/// weaknesses.jsonl, the witness that it could be escaped in witnesses.jsonl, pictures of both as
/// weaknesses/N and weaknesses/N_escape.
void reportWeaknesses(const RequestCases& cases, const std::vector<PlannerTestResult>& results,
                      const KeptDrives& drives, const std::string& folder, const Config& config);

}  // namespace forge
