#pragma once

#include <vector>

#include "collision_forge/planner_test/statistics/rate_table.h"
#include "collision_forge/study/evaluation/calibration.h"
#include "collision_forge/study/evaluation/clip_evaluation.h"
#include "collision_forge/study/evaluation/options.h"

namespace forge {

// What the rows of RequestEvaluator say; docs/protocols.md defines every figure.

/// The tables: for each measure of the strict protocol the methods that count in it (for a measure
/// by angle bands or by full definitions the searches with these rules, called by the
/// plan's method and "replay"), once of all requests and, but for angle bands, once of those that
/// the road allows; with a history search the headlines among the requests that replay
/// meets with any seed, replay left out; how many requests the road allows, and how many of the
/// others a search answered nevertheless; how many of the attacks that touch the ego are
/// believable; and for each method the share off the drivable area of its attacks that touch the
/// ego while the attacker itself is recorded without a gap, of the same attackers' own motion, and
/// the difference. Where the plan's attackers are believable there are no angle bands.
std::vector<RateTable> requestTables(const std::vector<ResultRow>& rows,
                                     const EvaluationPlan& plan);

/// One a column of the strict protocol that the plan has; none but for a history search.
std::vector<Calibration> requestCalibrations(const std::vector<ResultRow>& rows,
                                             const EvaluationPlan& plan);

}  // namespace forge
