#pragma once

#include "collision_forge/attack/search/attack_method.h"

namespace forge {

/// Returns the verified attack for a request, and further ones in `alternatives` if the request
/// wants more than one: generateOne(), then findAlternatives(). Main entry point of the attack
/// layer; runs on the caller's thread.
Realization generateCollision(const AttackMethod& method, const Moment& moment,
                              const CollisionRequest& request, const PredictionOptions& options);

}  // namespace forge
