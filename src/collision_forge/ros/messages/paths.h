#pragma once

#include <nav_msgs/Path.h>

#include <vector>

#include "collision_forge/base/scene/attack.h"
#include "collision_forge/base/scene/track.h"

/// Motions as nav_msgs/Path for other tools. In the map frame, at height 0; every pose is the
/// middle of a box and has its own stamp, the path that of its first pose.
namespace forge {

nav_msgs::Path toPath(const std::vector<TrajectoryPoint>& points);

/// Returns the known part of a track from `begin` to `end`, s, with its poses at both times.
nav_msgs::Path toPath(const Track& track, double begin, double end);

}  // namespace forge
