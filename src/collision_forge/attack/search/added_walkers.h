#pragma once

#include "collision_forge/attack/search/added_vehicle.h"

namespace forge {

/// Finds people of the requested class on foot, by default adults, that could have been in the
/// scene all along and then hit the ego with the requested type and time. Each waits at the
/// roadside, where people walk (isWherePeopleWalk()), since the recording's first frame, touches no
/// recorded agent, and then walks or runs straight to the meeting place: from both sides for a
/// crossing. Live, where the past cannot be changed, none is found. Random draws depend only on the
/// request's seed.
AddedVehicles addWalkers(const AddedVehicleInput& input, const AttackOptions& options);

}  // namespace forge
