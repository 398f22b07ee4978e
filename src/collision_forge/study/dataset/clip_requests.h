#pragma once

#include <cstdint>
#include <vector>

#include "collision_forge/attack/search/options.h"
#include "collision_forge/base/scene/collision_request.h"
#include "collision_forge/base/scene/scene.h"
#include "collision_forge/study/dataset/options.h"

namespace forge {

/// Frames from the begin of a clip to its impact that `options` allow, at 2 Hz: 9 to 18 for 4.5 to
/// 9 s.
std::vector<int> clipLengths(const DatasetOptions& options);

/// The clips that are tried on a recording, in replay mode and for any attacker. Clips begin every
/// `begin_stride` seconds; kCollideNowFrame frames later is now. For every begin and type as many
/// lengths as `attempts` says are drawn, each at most once, from those whose impact lies before the
/// recording's last frame. TTA is the recorded time from now to the impact's frame. Left out are
/// begins where the ego is slower than `min_ego_speed`, where frames do not come at 2 Hz (now and
/// impact would be other frames to a reader of the clip), and what checkRequest() refuses.
///
/// In order of begin, type, draw. Every request has a seed of its own, which follows from `seed`,
/// scene, begin, type and draw.
std::vector<SceneRequest> listClipRequests(const Scene& scene, const DatasetOptions& options,
                                           const PredictionOptions& prediction, std::uint64_t seed);

}  // namespace forge
