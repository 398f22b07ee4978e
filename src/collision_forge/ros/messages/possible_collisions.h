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

/// Returns one request per type and time (s from t0), ordered by type, then time. Empty `types`:
/// all five, or the type of the request's manoeuvre; empty `ttas`: `usual_ttas`. Returns
/// kInvalidInput if `request` has a type or a time, kUnknownType for an unknown type, else the
/// status of the failed conversion. `crash` has the defaults of the crash definition.
std::variant<std::vector<CollisionRequest>, Status> requestsForEach(
    collision_forge::CollisionRequest request, const std::vector<std::string>& types,
    std::vector<double> ttas, const std::vector<double>& usual_ttas, const CrashDefinition& crash);

/// Fills in attack, alternatives and summary only for kOk. `method`: name of the method; `now`: t0,
/// s.
collision_forge::CollisionAnswer toMessage(const CollisionRequest& request, const Attack& answer,
                                           const std::string& method, double now);

/// Summarises the attacks of `answers` into `collisions`, for each answer by descending confidence.
/// Skips failures that depend on the scene; returns the first failure that the request causes.
Status listPossible(const std::vector<collision_forge::CollisionAnswer>& answers,
                    std::vector<collision_forge::PossibleCollision>& collisions);

}  // namespace forge
