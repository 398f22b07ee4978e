#pragma once

#include <ros/time.h>
#include <rosbag/message_instance.h>

#include <optional>

namespace forge {

/// Returns the header stamp of a message that shows agents or the ego: agents, their markers (of
/// the first one), the transform of the ego, or odometry. Returns nullopt for other topics, for
/// other types, and for a message without markers or without the transform.
std::optional<ros::Time> headerStampOf(const rosbag::MessageInstance& instance);

}  // namespace forge
