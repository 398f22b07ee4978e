#pragma once

#include "collision_forge/attack/verify/strict_outcome.h"
#include "collision_forge/study/evaluation/result_row.h"

namespace forge {

/// Copies the outcome of the strict protocol to `row` (`meets` in the order of measuresOf()): the
/// measures; with a contact its time (relative to `now`, t0 on the scene's clock, s), its heading
/// and the off-road share; and as note the broken limit, the agent touched earlier and the reason
/// why the motion is implausible, those that exist, separated by "; ". Other fields of `row` stay.
void describeOutcome(const StrictOutcome& outcome, double now, ResultRow& row);

}  // namespace forge
