#pragma once

#include "collision_forge/attack/verify/strict_outcome.h"
#include "collision_forge/study/evaluation/result_row.h"

namespace forge {

/// Copies the outcome of the strict protocol to `row` (`meets` in the order of measuresOf()): the
/// measures, time (relative to `now`, t0 on the scene's clock, s) and heading of the contact, the
/// off-road share, and as note the broken limit, the agent touched earlier and the reason why the
/// motion is implausible.
void describeOutcome(const StrictOutcome& outcome, double now, ResultRow& row);

}  // namespace forge
