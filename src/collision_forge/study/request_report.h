#pragma once

#include <vector>

#include "collision_forge/study/calibration.h"
#include "collision_forge/study/clip_evaluation.h"
#include "collision_forge/study/options.h"
#include "collision_forge/study/rate_table.h"

namespace forge {

// What the rows of RequestEvaluator say; docs/protocols.md defines every figure.

/// The tables: for each measure of the strict protocol the methods that count in it (for a measure
/// by angle bands or by full definitions the searches with these rules, called by the
/// plan's method and "replay"); with a history search the headlines among the requests that replay
/// meets with any seed, replay left out; and for each method the share off the drivable area of its
/// attacks that touch the ego while the attacker itself is recorded without a gap, of the same
/// attackers' own motion, and the difference.
std::vector<RateTable> requestTables(const std::vector<ResultRow>& rows, const EvaluationPlan& plan,
                                     const StatisticsOptions& options);

/// One a column of the strict protocol; none but for a history search.
std::vector<Calibration> requestCalibrations(const std::vector<ResultRow>& rows,
                                             const EvaluationPlan& plan,
                                             const StatisticsOptions& options);

}  // namespace forge
