#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "collision_forge/attack/search/options.h"
#include "collision_forge/base/scene/collision_request.h"
#include "collision_forge/base/scene/scene.h"

namespace forge {

/// Counts of the instants (t0) that listRequests() considered, summed over its calls; `slow` and
/// `late` are parts of `instants`.
struct RequestTally {
  std::size_t instants = 0;  ///< all instants: frames nearest to every RequestListOptions::stride
  std::size_t slow = 0;      ///< instants with an ego below RequestListOptions::min_ego_speed
  std::size_t late = 0;  ///< instants not counted in `slow` that are too close to the end of the
                         ///< recording for every TTA
};

/// Returns the requests that a recording allows, none without frames or ego states: at the frame
/// nearest to every `list.stride` s from its first frame (of two equally near frames the earlier
/// one), for every TTA, type and attacker of `list`, with its seed and an empty name; other fields
/// as in `asked`, whose type, tta, attacker and seed are not used. Omits requests whose contact
/// could lie after the recording (TTA plus `time_tolerance`, s), with an ego slower than
/// list.min_ego_speed, or that checkRequest() rejects. Order: time, TTA, type, attacker as in the
/// scene. The end of the recording is the last frame or ego state, whichever is earlier; each frame
/// is used once. Adds to `tally` unless it is null. Throws std::invalid_argument if the stride is
/// not positive.
std::vector<SceneRequest> listRequests(const Scene& scene, const RequestListOptions& list,
                                       const PredictionOptions& options, double time_tolerance,
                                       const CollisionRequest& asked = {},
                                       RequestTally* tally = nullptr);

}  // namespace forge
