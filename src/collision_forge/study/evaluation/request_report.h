#pragma once

#include <optional>
#include <vector>

#include "collision_forge/planner_test/statistics/rate_table.h"
#include "collision_forge/study/evaluation/calibration.h"
#include "collision_forge/study/evaluation/clip_evaluation.h"
#include "collision_forge/study/evaluation/options.h"

namespace forge {

// Tables over the rows of RequestEvaluator; docs/protocols.md defines every figure.

/// Returns the tables of an evaluation of requests, from all its rows, with one row per method of
/// requestRowMethods() unless stated otherwise, in this order:
///
/// 1. For each measure of measuresOf(kStrict) but the two by angle bands, two tables: the rate of
///    each method over all requests, and over the requests that the road allows.
/// 2. For a seeded method outside replay mode: all conditions over the requests that replay mode
///    solves with any seed (recall against replay mode), without the row "replay"; then the same
///    over the requests that the road allows.
/// 3. The share of requests that the road allows, with the single row "requests"; for a seeded
///    method then the share of the others for which a method returned an attack, verified or not,
///    without rows for baselines.
/// 4. The share of plausible attacks among the attacks that touch the recorded ego.
std::vector<RateTable> requestTables(const std::vector<ResultRow>& rows,
                                     const EvaluationPlan& plan);

/// Returns the calibration of the confidences of the plan's method against all conditions by full
/// definitions; nullopt unless the plan has a seeded method outside replay mode.
std::optional<Calibration> requestCalibration(const std::vector<ResultRow>& rows,
                                              const EvaluationPlan& plan);

}  // namespace forge
