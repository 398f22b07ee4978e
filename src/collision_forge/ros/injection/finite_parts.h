#pragma once

#include <collision_forge/AgentArray.h>
#include <nav_msgs/Odometry.h>
#include <tf2_msgs/TFMessage.h>

namespace forge {

// Each function removes non-finite values (NaN, infinity) from a message and returns the number of
// changes, 0 for a message without such values.

/// Drops agents with a non-finite pose or size; sets velocities with a non-finite part to zero.
/// Counts each dropped agent and each changed velocity.
int keepFinite(collision_forge::AgentArray& message);

/// Drops transforms with a non-finite translation or rotation; the message may be empty afterwards.
int keepFinite(tf2_msgs::TFMessage& message);

/// Changes nothing; returns 1 if pose or twist is not finite and the message must be dropped, else
/// 0.
int keepFinite(const nav_msgs::Odometry& message);

}  // namespace forge
