#pragma once

#include "collision_forge/attack/verify/strict_outcome.h"
#include "collision_forge/study/evaluation/result_row.h"

namespace forge {

/// Fills in what the outcome says: which measures are met, when and how the boxes touch, the share
/// off the road, and as a note the broken limit, whom the attacker touches before and what no
/// driver would do.
void describeOutcome(const StrictOutcome& outcome, double now, ResultRow& row);

}  // namespace forge
