#pragma once

#include <collision_forge/CollisionAnswer.h>
#include <collision_forge/CollisionRequest.h>
#include <collision_forge/PossibleCollision.h>

#include <string>
#include <variant>
#include <vector>

#include "collision_forge/base/scene/attack.h"
#include "collision_forge/base/scene/collision_request.h"

namespace forge {

/// Returns one request per type and time to attack (s from t0), in the order of `types`, then of
/// `ttas`; the other fields come from `request`. `types`: names, "any" means all; empty: the
/// type of the request's manoeuvre, or without one the five types of kCollisionTypes. Empty `ttas`:
/// `usual_ttas`. A type named twice has its requests twice. Returns kInvalidInput if `request` has
/// a type or a time, kUnknownType for an unknown type, else the status of the failed conversion.
/// `crash`: as in fromMessage().
std::variant<std::vector<CollisionRequest>, Status> requestsForEach(
    collision_forge::CollisionRequest request, const std::vector<std::string>& types,
    std::vector<double> ttas, const std::vector<double>& usual_ttas, const CrashDefinition& crash);

/// Returns `answer`, the result of `request`, as a message. Attack, alternatives and summary
/// (summaryOf()) are set only for kOk. `method`: name of the method; `now`: t0, s.
collision_forge::CollisionAnswer toMessage(const CollisionRequest& request, const Attack& answer,
                                           const std::string& method, double now);

/// Appends a summary of each attack of `answers` and of its alternatives to `collisions`: in the
/// order of the answers, and within each answer by descending confidence. Skips failures that
/// depend on the scene (dependsOnScene()); stops at the first other failure and returns its code
/// and message. Otherwise returns kOk, whose message is "", except if `collisions` is then empty
/// and there are answers: then it names the most frequent status code (of several the one that
/// comes first), its count and the message of the first answer that has it.
Status listPossible(const std::vector<collision_forge::CollisionAnswer>& answers,
                    std::vector<collision_forge::PossibleCollision>& collisions);

}  // namespace forge
