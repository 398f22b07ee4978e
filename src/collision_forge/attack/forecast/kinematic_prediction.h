#pragma once

#include "collision_forge/base/map/lane_queries.h"
#include "collision_forge/base/scene/scene.h"

namespace forge {

inline constexpr double kPredictionStep = 0.1;  ///< s between predicted states, of the ego too
// A vehicle that is farther from every lane, or deviates more from its direction, does not follow
// it:
inline constexpr double kOnLaneDistance = 2.0;    ///< m to the centreline
inline constexpr double kOnLaneHeading = 0.7854;  ///< rad (45 degrees)

/// Predicts where everybody goes from now to `horizon` seconds later without knowing the future:
/// vehicles that fit a lane follow it at constant speed (at each branch the straightest successor),
/// their lateral offset fading; all others keep their velocity; agents below the standstill speed
/// stay. Only agents seen at now are predicted. The first state of every track is now's.
Future predictFuture(const Snapshot& snapshot, const LaneIndex& lanes, double horizon);

}  // namespace forge
