#pragma once

#include <collision_forge/Attack.h>
#include <collision_forge/AttackRequest.h>

#include <string>

#include "collision_forge/base/scene/collision_request.h"

namespace forge {

/// What an attack was asked for, of which instant, by which method and version. `configuration` is
/// a fingerprintOfAll(). It is the method's own attack; what tells of a bag is left empty.
collision_forge::AttackRequest attackRequest(const CollisionRequest& request,
                                             const collision_forge::Attack& attack,
                                             const std::string& configuration);

}  // namespace forge
