#pragma once

#include <collision_forge/Attack.h>
#include <collision_forge/AttackRequest.h>

#include <string>

#include "collision_forge/base/scene/collision_request.h"

namespace forge {

/// Returns the message with the request, t0, method and version of an attack. `configuration` is a
/// fingerprintOfAll(), `alternative` the attack's number as in attackOf(). The fields that describe
/// a bag stay empty.
collision_forge::AttackRequest attackRequest(const CollisionRequest& request,
                                             const collision_forge::Attack& attack,
                                             const std::string& configuration,
                                             std::uint32_t alternative);

}  // namespace forge
