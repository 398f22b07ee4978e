#include "collision_forge/ros/injection/header_stamp.h"

#include <collision_forge/AgentArray.h>
#include <nav_msgs/Odometry.h>
#include <tf2_msgs/TFMessage.h>
#include <visualization_msgs/MarkerArray.h>

#include <algorithm>

#include "collision_forge/ros/bags/bag_file.h"
#include "collision_forge/ros/injection/post_crash_ego.h"
#include "collision_forge/ros/messages/topic_names.h"

namespace forge {
namespace {

std::optional<ros::Time> headerStamp(const collision_forge::AgentArray& message) {
  return message.header.stamp;
}
std::optional<ros::Time> headerStamp(const nav_msgs::Odometry& message) {
  return message.header.stamp;
}
std::optional<ros::Time> headerStamp(const visualization_msgs::MarkerArray& message) {
  if (message.markers.empty()) return std::nullopt;
  return message.markers.front().header.stamp;
}
std::optional<ros::Time> headerStamp(const tf2_msgs::TFMessage& message) {
  const auto ego =
      std::find_if(message.transforms.begin(), message.transforms.end(), PostCrashEgo::isEgo);
  if (ego == message.transforms.end()) return std::nullopt;
  return ego->header.stamp;
}

template <typename Message>
std::optional<ros::Time> headerStamp(const rosbag::MessageInstance& instance) {
  const auto message = instance.instantiate<Message>();
  return message ? headerStamp(*message) : std::nullopt;
}

}  // namespace

std::optional<ros::Time> headerStampOf(const rosbag::MessageInstance& instance) {
  const std::string& topic = instance.getTopic();
  std::optional<ros::Time> stamp;
  if (topic == bagTopic(names::kAgents)) stamp = headerStamp<collision_forge::AgentArray>(instance);
  if (topic == names::kTf) stamp = headerStamp<tf2_msgs::TFMessage>(instance);
  if (topic == bagTopic(names::kOdometry)) stamp = headerStamp<nav_msgs::Odometry>(instance);
  if (topic == bagTopic(names::kAnnotationMarkers)) {
    stamp = headerStamp<visualization_msgs::MarkerArray>(instance);
  }
  return stamp;
}

}  // namespace forge
