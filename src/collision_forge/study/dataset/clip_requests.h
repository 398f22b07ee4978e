#pragma once

#include <cstdint>
#include <vector>

#include "collision_forge/attack/search/options.h"
#include "collision_forge/base/scene/collision_request.h"
#include "collision_forge/base/scene/scene.h"
#include "collision_forge/study/dataset/options.h"

namespace forge {

/// Returns the allowed lengths of clips in frame intervals at 2 Hz, from begin to impact,
/// ascending: 9 to 18 for min_length 4.5 s and max_length 9 s; other limits are rounded inwards.
std::vector<int> clipLengths(const DatasetOptions& options);

/// Returns the requests (replay mode, any attacker) for the clips to try on a recording, in order
/// of begin, type and draw.
///
/// Clips consist of collideFrames() and begin at the first frame and then every `begin_stride` s
/// (to half a frame interval); t0 is kCollideNowFrame frames after the begin. For each begin and
/// type of kCollisionTypes, draws `attempts` different lengths (all if there are fewer) among the
/// lengths whose impact is before the recording's last frame. The TTA is the recorded time from t0
/// to the frame of the impact. Skips:
/// - begins with an ego slower than `min_ego_speed` at t0,
/// - frames that are not 2 Hz apart, because readers of the clip count frames,
/// - requests that checkRequest() rejects.
///
/// The seed of a request is derived from `seed`, scene, begin, type and draw.
std::vector<SceneRequest> listClipRequests(const Scene& scene, const DatasetOptions& options,
                                           const PredictionOptions& prediction, std::uint64_t seed);

}  // namespace forge
