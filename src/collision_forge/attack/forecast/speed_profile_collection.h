#pragma once

#include <vector>

#include "collision_forge/attack/forecast/options.h"
#include "collision_forge/attack/forecast/speed_situations.h"
#include "collision_forge/base/map/lane_queries.h"
#include "collision_forge/base/scene/scene.h"

namespace forge {

/// Returns one row per annotation frame of a recording except the first. `ahead` refers to the
/// candidate path that the ego followed afterwards. If two frames are not about kProfileStep apart,
/// a frame number is skipped, so that no profile spans the gap.
std::vector<SpeedProfileRow> collectSpeedProfiles(const Scene& scene, const LaneIndex& lanes,
                                                  const EgoPathOptions& options);

}  // namespace forge
