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

/// The request for each of these types and times: by type, then time. No types: all five, or that
/// of its manoeuvre; no ttas: those given as usual. kInvalidInput where the request names a type or
/// a time itself, kUnknownType for a type that there is not, and what the conversion of the request
/// declines. `crash` is what counts as the crash where the request does not say.
std::variant<std::vector<CollisionRequest>, Status> requestsForEach(
    collision_forge::CollisionRequest request, const std::vector<std::string>& types,
    std::vector<double> ttas, const std::vector<double>& usual_ttas, const CrashDefinition& crash);

/// Attack, alternatives and summary are filled in with kOk alone. `method` made the attacks, `now`
/// is the moment's, s.
collision_forge::CollisionAnswer toMessage(const CollisionRequest& request, const Attack& answer,
                                           const std::string& method, double now);

/// The attacks of these answers in short, those of each answer as sure as they are. What the scene
/// does not allow is left out; an answer that says something against the request itself is
/// returned.
Status listPossible(const std::vector<collision_forge::CollisionAnswer>& answers,
                    std::vector<collision_forge::PossibleCollision>& collisions);

}  // namespace forge
