#pragma once

#include <string>
#include <vector>

#include "collision_forge/attack/search/options.h"
#include "collision_forge/base/scene/collision_request.h"
#include "collision_forge/base/scene/scene.h"

namespace forge {

/// The requests that can be made of a recording: at the frames nearest to every `stride` seconds
/// from its first on, for every TTA, type and attacker of the options. Left out are those whose
/// impact could lie after the recording (TTA and `time_tolerance` are within it), where
/// the ego is slower than `min_ego_speed`, and what checkRequest() refuses (too little history, an
/// attacker that cannot, controls that the type contradicts). What a request asks for besides is as
/// in `asked`. In order of now, TTA, type, then attacker as in the scene. Throws
/// std::invalid_argument for a stride that is not positive.
std::vector<SceneRequest> listRequests(const Scene& scene, const RequestListOptions& list,
                                       const PredictionOptions& options, double time_tolerance,
                                       const CollisionRequest& asked = {});

}  // namespace forge
