#pragma once

#include <vector>

#include "attack/attack.h"
#include "attack/options.h"
#include "attack/verification.h"

namespace forge {

/// A verified attack, or why there is none.
struct Realization {
  Status status;
  CollisionPattern pattern;  ///< the variation that was realised; these three with kOk only
  AttackerTrajectory trajectory;
  CollisionReport report;
};

/// Varies every pattern (heading, slide along the ego's side, speed at impact; the draws follow
/// from the request's seed), keeps what can be driven within the limits, verifies in order of
/// effort, and returns the best of the first `compared` verified crashes: least effort and least
/// off the road. Same input and seed, same answer. Throws std::invalid_argument for a pattern whose
/// attacker is not in the snapshot, or whose time is not after now.
Realization realize(const std::vector<CollisionPattern>& patterns, const VerificationInput& input,
                    const AttackOptions& options);

}  // namespace forge
