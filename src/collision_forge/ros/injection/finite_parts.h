#pragma once

#include <collision_forge/AgentArray.h>
#include <nav_msgs/Odometry.h>
#include <tf2_msgs/TFMessage.h>

namespace forge {

// What of a message has numbers where numbers must be. Each returns how much was changed.

/// Agents whose pose or size is not finite are left out, velocities that are not are none.
int keepFinite(collision_forge::AgentArray& message);

/// Transforms that are not finite are left out.
int keepFinite(tf2_msgs::TFMessage& message);

/// 1 where pose or twist is not finite: nothing of it is of use then.
int keepFinite(const nav_msgs::Odometry& message);

}  // namespace forge
