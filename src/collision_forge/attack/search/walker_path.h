#pragma once

#include <array>
#include <optional>

#include "collision_forge/base/geometry/polyline.h"
#include "collision_forge/base/scene/track.h"

namespace forge {

inline constexpr double kBeyondMeeting = 15.0;  ///< m of walkerPath() beyond the meeting place

/// How people of a class step out into the road.
struct Gait {
  std::array<double, 3> speeds;  ///< m/s: slow, fast, fastest
  double acceleration = 0.0;     ///< m/s2 from rest to these speeds
  double fastest_mean = 0.0;     ///< m/s, largest mean speed over the path, started from rest
};
/// Returns the gait of a class on foot: pedestrians walk, walk fast or run, runners run.
Gait gaitOf(AgentClass agent_class);

/// Returns the path of a pedestrian from `start` to the pose `meeting` (both box centres, map
/// frame) and kBeyondMeeting m straight on: across the direction of `meeting`, which is along the
/// kerb for a pedestrian who crosses the road, until `meeting` lies straight ahead (a detour below
/// 0.3 m is left out), then towards it. Empty if `meeting` would lie behind or less than 0.5 m
/// ahead of `start`, along its direction.
std::optional<Polyline> walkerPath(const Pose2& start, const Pose2& meeting);

}  // namespace forge
