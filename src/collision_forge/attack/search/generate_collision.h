#pragma once

#include "collision_forge/attack/search/attack_method.h"

namespace forge {

/// The way from a request to its verified attacks: generateOne(), and where the request asks for
/// more than one, findAlternatives().
Realization generateCollision(const AttackMethod& method, const Moment& moment,
                              const CollisionRequest& request, const PredictionOptions& options);

}  // namespace forge
