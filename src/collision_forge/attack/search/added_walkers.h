#pragma once

#include "collision_forge/attack/search/added_vehicle.h"

namespace forge {

/// Finds at most 8 people of the requested class on foot, by default pedestrians (adults who walk),
/// that could have been in the scene all along and then hit the ego with the requested type and
/// time. Each waits at the roadside, where people walk (isWherePeopleWalk()), since the recording's
/// first frame, touches no recorded agent, and then walks or runs (on average at most
/// Gait::fastest_mean of the class) straight to the meeting place: from both sides for a crossing.
/// Live, where the past cannot be changed, none is found. If `found` is empty, `status` is
/// kNoCandidate with the reasons. options.added.kinds must have the class. Random draws depend only
/// on the request's seed.
AddedVehicles addWalkers(const AddedVehicleInput& input, const AttackOptions& options);

}  // namespace forge
