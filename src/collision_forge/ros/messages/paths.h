#pragma once

#include <nav_msgs/Path.h>

#include <vector>

#include "collision_forge/base/scene/attack.h"
#include "collision_forge/base/scene/track.h"

/// Converts motions to nav_msgs/Path for other tools: map frame, height 0, poses of the box middle.
/// Each pose has its own stamp; the path has the stamp of its first pose, 0 without poses.
namespace forge {

/// Returns one pose per point, in their order.
nav_msgs::Path toPath(const std::vector<TrajectoryPoint>& points);

/// Returns the known states of `track` from `begin` to `end` (s, clock of the track), with
/// interpolated states at both unless the track has none there (stateAt()). Requires `begin` <
/// `end`.
nav_msgs::Path toPath(const Track& track, double begin, double end);

}  // namespace forge
