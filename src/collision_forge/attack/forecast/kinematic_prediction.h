#pragma once

#include "collision_forge/attack/forecast/options.h"
#include "collision_forge/base/map/lane_queries.h"
#include "collision_forge/base/scene/scene.h"

namespace forge {

/// Predicts where everybody goes from now to `horizon` seconds later without knowing the future:
/// vehicles that fit a lane follow it at constant speed (at each branch the straightest successor),
/// their lateral offset fading; all others keep their velocity; agents below the standstill speed
/// stay. Only agents seen at now are predicted. The first state of every track is now's.
Future predictFuture(const Snapshot& snapshot, const LaneIndex& lanes, double horizon,
                     const PredictionOptions& options);

}  // namespace forge
