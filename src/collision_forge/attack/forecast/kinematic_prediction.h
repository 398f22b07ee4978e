#pragma once

#include "collision_forge/base/map/lane_queries.h"
#include "collision_forge/base/scene/scene.h"

namespace forge {

inline constexpr double kPredictionStep = 0.1;  ///< s between predicted states, of the ego too
// A vehicle that is farther from every lane, or deviates more from its direction, does not follow
// it:
inline constexpr double kOnLaneDistance = 2.0;    ///< m to the centreline
inline constexpr double kOnLaneHeading = 0.7854;  ///< rad (45 degrees)

/// Predicts ego and other agents (box centres, map frame) from t0 to at least t0 + `horizon` (s)
/// from the snapshot alone, one state per kPredictionStep. A vehicle on a lane follows it at
/// constant speed, at branches the straightest successor, while its lateral offset decays; all
/// others keep their newest recorded velocity and yaw; agents below kStandstillSpeed stand still.
/// Where the lanes end, the path continues straight. Agents without a state at t0 are omitted. The
/// first state of every track has the pose at t0, the last is at the first multiple of
/// kPredictionStep at or after `horizon`; agents keep their order. `ego_samples` stays empty.
/// Throws std::invalid_argument if the ego has no states.
Future predictFuture(const Snapshot& snapshot, const LaneIndex& lanes, double horizon);

}  // namespace forge
