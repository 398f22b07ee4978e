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

/// Subtracted from the score of an added motorcycle if the request names no class, because
/// motorcycles are rare in traffic.
inline constexpr double kRidingCost = 0.15;

/// A vehicle that is not in the recording, and how it could hit the ego.
struct AddedVehicle {
  Track track;                             ///< from its first frame to t0, at the frame times
  ReferencePath way;                       ///< path of its motion, beyond the contact
  std::vector<CollisionPattern> patterns;  ///< with the track's id as attacker
};

/// Vehicles that fit into the scene: the simplest motions first, motorcycles last.
struct AddedVehicles {
  std::vector<AddedVehicle> found;
  Status status;  ///< if `found` is empty: kNoCandidate or kRoadDoesNotAllow
};

/// Returns an id for a further added vehicle or pedestrian: "added-N", with the smallest N above
/// found.size() that no agent of `past` and no vehicle in `found` has.
std::string newVehicleId(const Snapshot& past, const std::vector<AddedVehicle>& found);

/// Finds vehicles that could have been in the scene all along and then hit the ego with the
/// requested type and time: along lanes that lead to it (fittingLanes()), at speeds of the
/// surrounding traffic, together with or beside the ego, or from a standstill. Each keeps the
/// limits of its class and its lane, touches no recorded agent, and existed before the ego could
/// observe it: since the recording's first frame, from outside the ego's sensing range, or occluded
/// by another vehicle. Live, the past cannot be changed, so it must be unobserved at t0. Random
/// draws depend only on the request's seed.
AddedVehicles addVehicles(const AddedVehicleInput& input, const AttackOptions& options);

/// Returns the best attack by `vehicles`, the result of addVehicles() for this input, with the
/// vehicle's past in its trajectory; without an attack, the reason. `input.snapshot` must not
/// contain them, and the request must not name an attacker.
Attack realizeByAdded(const AddedVehicles& vehicles, const AddedVehicleInput& input,
                      const AttackOptions& options, const TrajectoryRealizer& realizer,
                      SearchedMotion motion);

}  // namespace forge
