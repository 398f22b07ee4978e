#pragma once

#include "collision_forge/attack/forecast/options.h"
#include "collision_forge/base/map/lane_queries.h"
#include "collision_forge/base/scene/scene.h"

namespace forge {

/// Predicts ego and other agents from t0 to t0 + `horizon` (s) from the snapshot alone. A vehicle
/// on a lane follows it at constant speed, at branches the straightest successor, while its lateral
/// offset decays; all others keep their velocity; agents below options.standstill_speed stand
/// still. Agents without a state at t0 are omitted. The first state of every track is the one at
/// t0.
Future predictFuture(const Snapshot& snapshot, const LaneIndex& lanes, double horizon,
                     const PredictionOptions& options);

}  // namespace forge
