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

/// Returns a request for each combination of type and TTA (s), ordered by type, then TTA. Without
/// types: the type of the request's manoeuvre, or all five; without `ttas`: `usual_ttas`. Returns
/// kInvalidInput if the request itself has a type or TTA, kUnknownType for an unknown type, and
/// errors of the request's conversion. `crash` gives defaults for the request's empty fields.
std::variant<std::vector<CollisionRequest>, Status> requestsForEach(
    collision_forge::CollisionRequest request, const std::vector<std::string>& types,
    std::vector<double> ttas, const std::vector<double>& usual_ttas, const CrashDefinition& crash);

/// Fills in attack, alternatives and summary only with kOk. `method` names the method that made the
/// attacks, `now` is t0, s.
collision_forge::CollisionAnswer toMessage(const CollisionRequest& request,
                                           const Realization& answer, const std::string& method,
                                           double now);

/// Appends a summary of each attack to `collisions`, for each answer by falling confidence. Leaves
/// out requests that the scene does not allow; returns the first error of a request itself. If
/// nothing is feasible, the returned kOk has the commonest reason as message.
Status listPossible(const std::vector<collision_forge::CollisionAnswer>& answers,
                    std::vector<collision_forge::PossibleCollision>& collisions);

}  // namespace forge
