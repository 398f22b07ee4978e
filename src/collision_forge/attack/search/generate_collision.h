#pragma once

#include "collision_forge/attack/search/attack_method.h"

namespace forge {

/// Returns the request with the type of its attack: CollisionType::kAny becomes the type of
/// attack.pattern. Returns the request unchanged if it has another type or the attack is rejected.
CollisionRequest withTypeOf(CollisionRequest request, const Attack& attack);

/// Returns the verified attack for a request, and further ones in `alternatives` if the request
/// wants more than one: generateOne(), then findAlternatives(). In replay mode, reports also have
/// the drives of driveCarefully() in the recording. For CollisionType::kAny, returns the attack
/// with the greatest scoreOf() over all types (the first tried of equals), tried in an order that
/// depends on the seed, until one has the greatest possible score, 1; Attack::pattern has its type.
/// Types that checkControls() rejects are skipped; if it rejects all, its last status is returned.
/// Another rejection that does not depend on the scene (dependsOnScene()) is returned at once; if
/// all types are rejected, the status has their common code, or kNoAttackWithinLimits if they
/// differ. Without an attack, its status has the
/// code and the reason. Throws as AttackMethod::answer(). Main entry point of the attack layer;
/// runs on the caller's thread.
Attack generateCollision(const AttackMethod& method, const Moment& moment,
                         const CollisionRequest& request, const PredictionOptions& options);

}  // namespace forge
