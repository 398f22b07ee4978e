#pragma once

#include <optional>

#include "collision_forge/base/geometry/polyline.h"

namespace forge {

inline constexpr double kBeyondMeeting = 15.0;  ///< m of walkerPath() beyond the meeting place

/// Returns the path of a pedestrian from `start` to the pose `meeting` (both box centres, map
/// frame) and kBeyondMeeting m straight on: across the direction of `meeting`, which is along the
/// kerb for a pedestrian who crosses the road, until `meeting` lies straight ahead (a detour below
/// 0.3 m is left out), then towards it. Empty if `meeting` would lie behind or less than 0.5 m
/// ahead of `start`, along its direction.
std::optional<Polyline> walkerPath(const Pose2& start, const Pose2& meeting);

}  // namespace forge
