#pragma once

#include <vector>

#include "collision_forge/attack/forecast/speed_situations.h"
#include "collision_forge/base/map/lane_queries.h"
#include "collision_forge/base/scene/scene.h"

namespace forge {

/// What SpeedSituations are made of: a row for each annotation frame of a recording but the first.
/// The way ahead is that of the path that the ego went on to follow. Where frames are not about
/// kProfileStep apart, a frame number is left out, so that no profile goes on across.
std::vector<SpeedProfileRow> collectSpeedProfiles(const Scene& scene, const LaneIndex& lanes);

}  // namespace forge
