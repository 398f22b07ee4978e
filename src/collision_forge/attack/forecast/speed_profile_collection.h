#pragma once

#include <vector>

#include "collision_forge/attack/forecast/speed_situations.h"
#include "collision_forge/base/map/lane_queries.h"
#include "collision_forge/base/scene/scene.h"

namespace forge {

/// Returns one row per annotation frame of a recording, in time order, except the first frame
/// (number 0) and frames with fewer than two ego states in the 2.5 s up to them, interpolated every
/// kProfileStep. `lanes` must be the index of the scene's map. `ahead` refers to the candidate path
/// that the ego followed in the next 6 s. If two frames are not kProfileStep apart to 0.25 s, a
/// frame number is skipped, so that no profile spans the gap.
std::vector<SpeedProfileRow> collectSpeedProfiles(const Scene& scene, const LaneIndex& lanes);

}  // namespace forge
