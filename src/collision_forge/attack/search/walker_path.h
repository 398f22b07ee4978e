#pragma once

#include <array>
#include <optional>

#include "collision_forge/base/geometry/polyline.h"
#include "collision_forge/base/scene/track.h"

namespace forge {

/// m of path beyond the meeting place.
inline constexpr double kBeyondMeeting = 15.0;

/// How people of a class step out into the road.
struct Gait {
  std::array<double, 3> speeds;  ///< m/s: slow, fast, fastest
  double acceleration = 0.0;     ///< m/s2 from rest to these speeds
  double fastest_mean = 0.0;     ///< m/s over the way, started from rest
};
/// Returns the gait of a class on foot: pedestrians walk, walk fast or run, runners run.
Gait gaitOf(AgentClass agent_class);

/// Returns the path of a pedestrian from `start` to the pose `meeting` (both box centres, map
/// frame) and straight on: across the direction of `meeting`, which is along the kerb for a
/// pedestrian who crosses the road, until `meeting` lies ahead, then towards it. Empty if `meeting`
/// would lie behind.
std::optional<Polyline> walkerPath(const Pose2& start, const Pose2& meeting);

}  // namespace forge
