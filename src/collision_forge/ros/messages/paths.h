#pragma once

#include <nav_msgs/Path.h>

#include <vector>

#include "collision_forge/base/scene/attack.h"
#include "collision_forge/base/scene/track.h"

/// Ways as nav_msgs/Path, which other tools read. In the map frame, at height 0; every pose is the
/// middle of a box and has its own stamp, the path that of its first pose.
namespace forge {

nav_msgs::Path toPath(const std::vector<TrajectoryPoint>& points);

/// What is known of a track from `begin` to `end`, seconds, with where it is at either.
nav_msgs::Path toPath(const Track& track, double begin, double end);

}  // namespace forge
