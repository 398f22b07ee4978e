#pragma once

#include <collision_forge/Attack.h>
#include <collision_forge/AttackRequest.h>

#include <string>

#include "collision_forge/base/scene/collision_request.h"

namespace forge {

/// Returns the record of a request and its attack: t0 and method of the attack, and the version of
/// this package. `configuration`: fingerprintOfAll() of the configuration; `alternative`: number of
/// the attack among the attacks of the request, from 1 (PossibleCollision.alternative). The fields
/// about a bag (`now`, `after_contact`, `bag`) stay 0 or empty.
collision_forge::AttackRequest attackRequest(const CollisionRequest& request,
                                             const collision_forge::Attack& attack,
                                             const std::string& configuration,
                                             std::uint32_t alternative);

}  // namespace forge
