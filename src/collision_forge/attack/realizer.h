#pragma once

#include <string>
#include <vector>

#include "collision_forge/attack/options.h"
#include "collision_forge/scene/attack.h"
#include "collision_forge/verify/verification.h"

namespace forge {

/// A verified attack, or why there is none.
struct Realization {
  Status status;
  CollisionPattern pattern;  ///< as realised: the ego's pose is that of the future verified against
  AttackerTrajectory trajectory;  ///< these three with kOk only
  CollisionReport report;
};

/// Why an attack with this report is not verified, for people: "missed the ego", ...
std::string shortcomingOf(const CollisionReport& report);

/// What a share of the futures is worth as confidence: linear between the points of `curve`, which
/// are evenly spread over shares from 0 to 1.
double confidenceOf(double share, const std::vector<double>& curve);

/// Searches (searchAttacks()) around the patterns, and returns the best attack that passes verify()
/// in one of the ego's futures: of `future.ego_samples` half are searched, the share of the other
/// half tells the confidence (confidenceOf()); without samples the ego is known, and the confidence
/// is 1. Same input and seed, same answer. Declines with kLowConfidence below `min_confidence`.
/// Throws std::invalid_argument for a pattern whose attacker is not in the snapshot, or whose time
/// is not after now.
Realization realize(const std::vector<CollisionPattern>& patterns, const VerificationInput& input,
                    const AttackOptions& options);

}  // namespace forge
