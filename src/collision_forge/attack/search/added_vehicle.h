#pragma once

#include <vector>

#include "collision_forge/attack/search/added_paths.h"
#include "collision_forge/attack/search/options.h"
#include "collision_forge/attack/search/realizer.h"
#include "collision_forge/attack/search/search_task.h"
#include "collision_forge/base/map/reference_path.h"
#include "collision_forge/base/scene/attack.h"
#include "collision_forge/base/scene/scene.h"

namespace forge {

/// Added to the Attack::effort of an added motorcycle if the request names no class, because
/// motorcycles are rare in traffic.
inline constexpr double kRidingCost = 0.15;

/// A vehicle that is not in the recording, and how it could hit the ego.
struct AddedVehicle {
  Track track;        ///< from its first frame in the recording to t0, at the frame times
  ReferencePath way;  ///< path of its box centre from before its first frame to beyond the contact
  /// with the track's id as attacker; not empty, most promising first
  std::vector<CollisionPattern> patterns;
};

/// Vehicles that fit into the scene: the simplest motions first, motorcycles last.
struct AddedVehicles {
  std::vector<AddedVehicle> found;
  /// kOk, or if `found` is empty: kNoCandidate with the counted reasons, or kRoadDoesNotAllow with
  /// the reason
  Status status;
};

/// Returns an id for a further added vehicle or pedestrian: "added-N", with the smallest N above
/// found.size() such that neither an agent of `past` nor a vehicle in `found` has this id.
std::string newVehicleId(const Snapshot& past, const std::vector<AddedVehicle>& found);

/// Finds vehicles that could have been in the scene all along and then hit the ego with the
/// requested type and time: along lanes that lead to it (fittingLanes()), at speeds of the
/// surrounding traffic, together with or beside the ego, or from a standstill. Each keeps the
/// limits of its class and its lane, touches no recorded agent, and existed before the ego could
/// observe it: since the recording's first frame, from outside the ego's sensing range, or occluded
/// by another vehicle. In live scenes (`input.past` null), whose past cannot be changed, the
/// vehicle must instead be out of the ego's view (out of range or occluded) at t0. Returns at most
/// AddedVehicleOptions::candidates, or predicted_candidates if the ego's future is predicted. Does
/// not use CollisionRequest::attacker. Random draws depend only on the request's seed.
AddedVehicles addVehicles(const AddedVehicleInput& input, const AttackOptions& options);

/// Returns the attack with the greatest scoreOf() by `vehicles`, the result of addVehicles() or
/// addFromRoadside() for this input, with the vehicle's past in its trajectory; without an attack,
/// the reason. Calls `realizer` with `motion` once for all car-like vehicles (isCarLike()) and,
/// unless scoreOf() of their attack is at least SearchOptions::good_share, once for all others.
/// `input.snapshot` must not contain the vehicles, and the request must not name an attacker.
/// Throws as TrajectoryRealizer::realize().
Attack realizeByAdded(const AddedVehicles& vehicles, const AddedVehicleInput& input,
                      const AttackOptions& options, const TrajectoryRealizer& realizer,
                      SearchedMotion motion);

}  // namespace forge
