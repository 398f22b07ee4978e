#pragma once

#include <vector>

#include "collision_forge/attack/search/attack_method.h"

namespace forge {

/// Returns true if two attacks at t0 of `snapshot` differ in manoeuvre or attacker. Two added
/// vehicles count as the same attacker if they have the same class and stand on the same side of
/// the ego at t0 (touchedSide()).
bool areDistinct(const Attack& a, const Attack& b, const Snapshot& snapshot);

/// Returns up to request.alternatives - 1 further attacks, distinct from `first` and from each
/// other (areDistinct()), highest confidence first; empty if there are none. Requests them from
/// `method` with one additional constraint at a time: each other manoeuvre of the type (without
/// kBackOut, for plausible attackers also without kWrongWay), each other recorded vehicle (nearest
/// first), an added vehicle of each class; stops when there are enough. At equal confidence the one
/// found first comes first. Fields that the request sets itself are not varied. Each is verified
/// like any other attack. Distinct added vehicles get distinct ids ("-2", "-3" ... is appended).
/// `first` needs a trajectory and its report's manoeuvre. Throws as AttackMethod::answer().
std::vector<Attack> findAlternatives(const Attack& first, const AttackMethod& method,
                                     const Moment& moment, const CollisionRequest& request,
                                     const PredictionOptions& options);

/// Returns attack `number` (from 1) of a result as a result of its own, without alternatives: 1 is
/// the first attack, 2 the first alternative. Returns a rejection kNoAttackWithinLimits for 0 or if
/// there are fewer, and a result without an attack unchanged.
Attack attackOf(Attack answer, std::size_t number);

}  // namespace forge
