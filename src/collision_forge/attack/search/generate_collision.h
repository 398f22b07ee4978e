#pragma once

#include "collision_forge/attack/search/attack_method.h"

namespace forge {

/// Returns the verified attack for a request, and further ones in `alternatives` if the request
/// wants more than one: generateOne(), then findAlternatives(). In replay mode, reports also have
/// the drives of driveCarefully() in the recording. Main entry point of the attack
/// layer; runs on the caller's thread.
Attack generateCollision(const AttackMethod& method, const Moment& moment,
                         const CollisionRequest& request, const PredictionOptions& options);

}  // namespace forge
