#pragma once

#include "collision_forge/attack/search/added_vehicle.h"

namespace forge {

/// Finds at most 8 people on foot or vehicles that wait beside the road since the recording's first
/// frame, touch no recorded agent, and then move straight to the meeting place with the requested
/// type and time: from both sides for a crossing. Live, where the past cannot be changed, none is
/// found. If `found` is empty, `status` is kNoCandidate with the reasons.
///
/// - People of the requested class on foot, by default pedestrians (adults who walk), wait where
///   people walk (isWherePeopleWalk()), and then walk or run (on average at most
///   Gait::fastest_mean of the class).
/// - For Manoeuvre::kBackOut, a vehicle of the requested class, by default a car, stands in a bay
///   or a drive (isInBay()) with its rear towards the road, and then reverses.
///
/// options.added.kinds must have the class. Random draws depend only on the request's seed.
AddedVehicles addFromRoadside(const AddedVehicleInput& input, const AttackOptions& options);

}  // namespace forge
