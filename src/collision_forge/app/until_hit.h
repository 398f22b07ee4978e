#pragma once

#include <string>
#include <vector>

#include "collision_forge/planner_test/settings/config.h"
#include "collision_forge/planner_test/trials/kept_drives.h"
#include "collision_forge/planner_test/trials/request_cases.h"

namespace forge {

/// Reports the weaknesses of the planners (findWeaknesses(), also for their order) in `results`,
/// which holds one result per case of `cases` in the same order; each request must name a
/// manoeuvre. `drives`: the driven motions of `results`. Prints the five most severe weaknesses on
/// stdout (without any, a line that says so) and writes to `folder`, which must exist (throws
/// std::runtime_error if a file cannot be written):
/// - weaknesses.md: a table of all, the most severe first;
/// - weaknesses.jsonl: the hardest collision of each weakness, as a line of a scenario file; a case
///   that several weaknesses share is written once;
/// - witnesses.jsonl: for each weakness the evasive manoeuvre that avoids its hardest collision, as
///   motions of ego and attacker (box centres, map frame; m, rad, m/s, s from t0; keys:
///   docs/adaptive.md);
/// - weaknesses/N.png, .gif and weaknesses/N_escape.png, .gif: pictures of both; N: rank, from 1.
///
/// The three files replace older ones; without a weakness the .jsonl files are empty. Empties the
/// folder weaknesses/ first. Takes as long as one request per weakness, because the
/// attacker's first plan is generated again.
void reportWeaknesses(const RequestCases& cases, const std::vector<PlannerTestResult>& results,
                      const KeptDrives& drives, const std::string& folder, const Config& config);

}  // namespace forge
