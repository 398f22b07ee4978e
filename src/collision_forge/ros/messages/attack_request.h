#pragma once

#include <collision_forge/Attack.h>
#include <collision_forge/AttackRequest.h>

#include <string>

#include "collision_forge/base/scene/collision_request.h"

namespace forge {

/// What an attack was asked for, of which instant, by which method and version. `configuration` is
/// a fingerprintOfAll(), `alternative` the number of the attack as of attackOf(). The fields that
/// describe a bag are left empty.
collision_forge::AttackRequest attackRequest(const CollisionRequest& request,
                                             const collision_forge::Attack& attack,
                                             const std::string& configuration,
                                             std::uint32_t alternative);

}  // namespace forge
