#pragma once

#include <vector>

#include "collision_forge/attack/search/attack_method.h"

namespace forge {

/// True when two attacks at one moment differ in manoeuvre or attacker. Added vehicles, which have
/// no identity of their own, are one attacker where they are of one class and come from the same
/// side of the ego: that of its box at which they stand now (touchedSide()).
bool areDistinct(const Realization& a, const Realization& b, const Snapshot& snapshot);

/// Up to `request.alternatives` - 1 attacks on a request that has been answered by `first`, each
/// distinct from that and from each other, the surest first. They are asked for by controls that
/// the request leaves open, one at a time: each manoeuvre of the type, then each other recorded
/// vehicle, the nearest first, then an added one of each class; so each is as verified as any
/// answer. Different vehicles that are added have different ids. Looks no further once there are
/// enough. Of `first` the trajectory and the report's
/// manoeuvre must be there.
std::vector<Realization> findAlternatives(const Realization& first, const AttackMethod& method,
                                          const Moment& moment, const CollisionRequest& request,
                                          const PredictionOptions& options);

/// Returns attack `number` of an answer, alone: 1 is the method's own, from 2 on follow the
/// alternatives in their order. Returns kNoAttackWithinLimits where the answer has fewer, and an
/// answer without an attack as it is.
Realization attackOf(Realization answer, std::size_t number);

}  // namespace forge
