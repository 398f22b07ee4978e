#pragma once

#include <string>
#include <vector>

#include "collision_forge/attack/attack_search.h"
#include "collision_forge/attack/options.h"
#include "collision_forge/scene/attack.h"
#include "collision_forge/verify/verification.h"

namespace forge {

/// Why an attack with this report is not what was asked for, for people: "missed the ego", ...;
/// empty where it is.
std::string shortcomingOf(const CollisionReport& report, const CollisionRequest& request);

/// Verified, believable if the request wants that, and of the manoeuvre, the ego's side, the
/// impact speed and the overlap that it names.
bool isAsAsked(const CollisionReport& report, const CollisionRequest& request);

/// What speaks for an answer: its confidence less its effort.
double worthOf(const Realization& answer);

/// The request names more than a type, a time and an attacker: how the crash shall be.
bool namesHow(const CollisionRequest& request);

/// What a share of the futures is worth as confidence: linear between the points of `curve`, which
/// are evenly spread over shares from 0 to 1.
double confidenceOf(double share, const std::vector<double>& curve);

/// Searches (searchAttacks()) from the patterns, and returns the best attack that passes verify()
/// in one of the ego's futures, with the pattern that it came from: of `future.ego_samples` half
/// are searched, the share of the other half tells the confidence (confidenceOf()); without samples
/// the ego is known, and the confidence is 1. `exact`: its contact is at one of the patterns
/// (isExact()), or there is no answer. Same input and seed, same answer. Declines with
/// kLowConfidence below `min_confidence`. Throws std::invalid_argument for a pattern whose attacker
/// is not in the snapshot, whose time is not after now, or with a number that is not finite or a
/// tolerance below 0. `ways` and `motion`: of believable attackers.
Realization realize(const std::vector<CollisionPattern>& patterns, const VerificationInput& input,
                    const AttackOptions& options, bool exact = false, const AttackerWays& ways = {},
                    SearchedMotion motion = SearchedMotion::kByRoutes);

}  // namespace forge
