#pragma once

#include <collision_forge/AgentArray.h>
#include <nav_msgs/Odometry.h>
#include <tf2_msgs/TFMessage.h>

namespace forge {

// Remove non-finite values from messages. Each function returns the number of changes.

/// Removes agents with a non-finite pose or size; sets non-finite velocities to 0.
int keepFinite(collision_forge::AgentArray& message);

/// Removes non-finite transforms.
int keepFinite(tf2_msgs::TFMessage& message);

/// Returns 1 if pose or twist is not finite (the message is unusable), else 0.
int keepFinite(const nav_msgs::Odometry& message);

}  // namespace forge
