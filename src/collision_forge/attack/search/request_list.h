#pragma once

#include <string>
#include <vector>

#include "collision_forge/attack/search/options.h"
#include "collision_forge/base/scene/collision_request.h"
#include "collision_forge/base/scene/scene.h"

namespace forge {

/// Returns the requests that a recording allows: at the frame nearest to every `list.stride` s from
/// its first frame, for every TTA, type and attacker of `list`; other fields as in `asked`. Omits
/// requests whose contact could lie after the recording (TTA plus `time_tolerance`, s), with an ego
/// slower than list.min_ego_speed, or that checkRequest() rejects. Order: time, TTA, type, attacker
/// as in the scene. Throws std::invalid_argument if the stride is not positive.
std::vector<SceneRequest> listRequests(const Scene& scene, const RequestListOptions& list,
                                       const PredictionOptions& options, double time_tolerance,
                                       const CollisionRequest& asked = {});

}  // namespace forge
