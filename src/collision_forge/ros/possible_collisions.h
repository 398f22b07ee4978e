#pragma once

#include <collision_forge/CollisionAnswer.h>
#include <collision_forge/CollisionRequest.h>
#include <collision_forge/PossibleCollision.h>

#include <string>
#include <variant>
#include <vector>

#include "collision_forge/scene/collision_request.h"

namespace forge {

/// Code and message of an answer.
Status statusOf(const collision_forge::CollisionAnswer& answer);

/// The request for each of these types and times: by type, then time. No types: all five, or that
/// of its manoeuvre; no ttas: those given as usual. kInvalidInput where the request names a type or
/// a time itself, kUnknownType for a type that there is not.
std::variant<std::vector<collision_forge::CollisionRequest>, Status> requestsForEach(
    const collision_forge::CollisionRequest& request, std::vector<std::string> types,
    std::vector<double> ttas, const std::vector<double>& usual_ttas);

/// The attacks of these answers in short, those of each answer as sure as they are. What the scene
/// does not allow is left out; an answer that says something against the request itself is
/// returned.
Status listPossible(const std::vector<collision_forge::CollisionAnswer>& answers,
                    std::vector<collision_forge::PossibleCollision>& collisions);

}  // namespace forge
