#pragma once

#include <vector>

#include "collision_forge/planner_test/statistics/rate_table.h"
#include "collision_forge/study/evaluation/calibration.h"
#include "collision_forge/study/evaluation/clip_evaluation.h"
#include "collision_forge/study/evaluation/options.h"

namespace forge {

// Tables over the rows of RequestEvaluator; docs/protocols.md defines every figure.

/// Returns the tables of an evaluation of requests:
///
/// 1. For each measure of the strict protocol, the rate of each method, over all requests and over
///    the requests that the road allows. A measure by angle bands (only if not `plan.believable`,
///    only over all requests) or by full definitions has only the searches with these rules.
/// 2. For a seeded method outside replay mode: the headline measures over the requests that replay
///    mode solves with any seed (recall against replay mode).
/// 3. The share of requests that the road allows, and how many of the others a search solved.
/// 4. The share of plausible attacks among the attacks that touch the ego.
/// 5. For each method: the off-road share of its attacks that touch the ego, of the same agents'
///    own recorded motion, and the difference.
std::vector<RateTable> requestTables(const std::vector<ResultRow>& rows,
                                     const EvaluationPlan& plan);

/// Returns one calibration per column of the strict protocol in the plan; empty unless the plan has
/// a seeded method outside replay mode.
std::vector<Calibration> requestCalibrations(const std::vector<ResultRow>& rows,
                                             const EvaluationPlan& plan);

}  // namespace forge
