#pragma once

#include <vector>

#include "collision_forge/attack/search/added_ways.h"
#include "collision_forge/attack/search/options.h"
#include "collision_forge/attack/search/realizer.h"
#include "collision_forge/attack/search/search_task.h"
#include "collision_forge/base/map/reference_path.h"
#include "collision_forge/base/scene/attack.h"
#include "collision_forge/base/scene/scene.h"

namespace forge {

/// Confidence that a motorcycle costs where the request names no class: few are on the roads.
inline constexpr double kRidingCost = 0.15;

/// A vehicle that nobody recorded, and how it could meet the ego.
struct AddedVehicle {
  Track track;                             ///< from its first frame to now, at the frames' times
  ReferencePath way;                       ///< that it drives along, on through the meeting
  std::vector<CollisionPattern> patterns;  ///< by its track's id, in the futures that it is for
};

/// Vehicles that fit into the scene, the ones that drive the most plainly first and motorcycles
/// last, or why none does.
struct AddedVehicles {
  std::vector<AddedVehicle> found;
  Status status;  ///< kNoCandidate or kRoadDoesNotAllow without any
};

/// Looks for vehicles that could have been in the scene all along and drive on into the ego: along
/// the lanes that lead to it (fittingLanes()), at the time asked for, at speeds of the traffic
/// there, with the ego or beside it, or out of a standstill. Each keeps the limits of its class and
/// its lane, touches nobody recorded, and was there before the ego could see it: from the
/// recording's first frame on, or from beyond AddedVehicleOptions::sensing_range, or from behind
/// somebody. Live, where what was seen cannot be changed, it is out of sight now. The draws follow
/// from the request's seed.
AddedVehicles addVehicles(const AddedVehicleInput& input, const AttackOptions& options);

/// The best attack of the vehicles that addVehicles() found for this input, of which the answer's
/// trajectory tells the past. `input` is without them, its request names no attacker.
Realization realizeByAdded(const AddedVehicles& vehicles, const AddedVehicleInput& input,
                           const AttackOptions& options, const TrajectoryRealizer& realizer,
                           SearchedMotion motion);

}  // namespace forge
