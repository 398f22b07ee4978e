#pragma once

#include <collision_forge/AgentArray.h>
#include <nav_msgs/Odometry.h>
#include <tf2_msgs/TFMessage.h>

namespace forge {

// Removes non-finite values from a message. Each function returns the number of changes.

/// Drops agents with a non-finite pose or size; sets non-finite velocities to zero.
int keepFinite(collision_forge::AgentArray& message);

/// Drops non-finite transforms.
int keepFinite(tf2_msgs::TFMessage& message);

/// Changes nothing; returns 1 if pose or twist is not finite and the message must be dropped, else
/// 0.
int keepFinite(const nav_msgs::Odometry& message);

}  // namespace forge
