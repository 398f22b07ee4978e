#include "collision_forge/ros/injection/post_crash_ego.h"

#include <algorithm>

#include "collision_forge/ros/injection/frame_between.h"
#include "collision_forge/ros/messages/conversions.h"
#include "collision_forge/ros/messages/topic_names.h"

namespace forge {
namespace {

geometry_msgs::Pose poseOf(const geometry_msgs::Transform& transform) {
  geometry_msgs::Pose pose;
  pose.position.x = transform.translation.x;
  pose.position.y = transform.translation.y;
  pose.position.z = transform.translation.z;
  pose.orientation = transform.rotation;
  return pose;
}

}  // namespace

bool PostCrashEgo::isEgo(const geometry_msgs::TransformStamped& transform) {
  return transform.header.frame_id == names::kMapFrame &&
         transform.child_frame_id == names::kBaseFrame;
}

PostCrashEgo::PostCrashEgo(const PostCrashMotion& crash, double center_offset)
    : crash_(crash), center_offset_(center_offset) {}

/// Returns an empty value if the contact is not between the two stamps.
std::optional<double> PostCrashEgo::ratioOfContact(const ros::Time& before,
                                                   const ros::Time& after) const {
  const ros::Time contact = stampOf(crash_.contactTime());
  if (contact <= before || contact >= after) return std::nullopt;
  return (contact - before).toSec() / (after - before).toSec();
}

geometry_msgs::Pose PostCrashEgo::poseAt(double time, const geometry_msgs::Pose& like) const {
  geometry_msgs::Pose pose = like;
  setPlanar(compose(crash_.egoAt(time).pose, {-center_offset_, 0.0, 0.0}), pose);
  return pose;
}

geometry_msgs::Transform PostCrashEgo::transformAt(double time,
                                                   const geometry_msgs::Transform& like) const {
  const geometry_msgs::Pose pose = poseAt(time, poseOf(like));
  geometry_msgs::Transform transform;
  transform.translation.x = pose.position.x;
  transform.translation.y = pose.position.y;
  transform.translation.z = pose.position.z;
  transform.rotation = pose.orientation;
  return transform;
}

std::optional<EgoBetween<tf2_msgs::TFMessage>> PostCrashEgo::atContact(
    const tf2_msgs::TFMessage& next) {
  const auto ego = std::find_if(next.transforms.begin(), next.transforms.end(), isEgo);
  if (ego == next.transforms.end() || !last_transform_) return std::nullopt;
  const auto ratio = ratioOfContact(last_transform_->header.stamp, ego->header.stamp);
  if (!ratio) return std::nullopt;
  last_transform_->header.stamp = stampOf(crash_.contactTime());
  last_transform_->transform = transformAt(crash_.contactTime(), last_transform_->transform);
  tf2_msgs::TFMessage message;
  message.transforms = {*last_transform_};
  return {{message, *ratio}};
}

tf2_msgs::TFMessage PostCrashEgo::changed(tf2_msgs::TFMessage message) {
  for (auto& transform : message.transforms) {
    if (!isEgo(transform)) continue;
    const double time = transform.header.stamp.toSec();
    if (time <= crash_.contactTime()) {
      last_transform_ = transform;
      continue;
    }
    transform.transform = transformAt(time, last_transform_.value_or(transform).transform);
  }
  return message;
}

std::optional<EgoBetween<nav_msgs::Odometry>> PostCrashEgo::atContact(
    const nav_msgs::Odometry& next) {
  if (!last_odometry_) return std::nullopt;
  const auto ratio = ratioOfContact(last_odometry_->header.stamp, next.header.stamp);
  if (!ratio) return std::nullopt;
  last_odometry_->header.stamp = stampOf(crash_.contactTime());
  last_odometry_->pose.pose = poseAt(crash_.contactTime(), last_odometry_->pose.pose);
  geometry_msgs::Twist& twist = last_odometry_->twist.twist;
  twist.linear = between(twist.linear, next.twist.twist.linear, *ratio);
  twist.angular = between(twist.angular, next.twist.twist.angular, *ratio);
  return {{*last_odometry_, *ratio}};
}

nav_msgs::Odometry PostCrashEgo::changed(nav_msgs::Odometry message) {
  const double time = message.header.stamp.toSec();
  if (time <= crash_.contactTime()) {
    last_odometry_ = message;
    return message;
  }
  message.pose.pose = poseAt(time, last_odometry_.value_or(message).pose.pose);
  const AgentState ego = crash_.egoAt(time);
  const double yaw = ego.pose.yaw;
  const Pose2 local = relativeTo({0.0, 0.0, yaw}, {ego.velocity.x(), ego.velocity.y(), yaw});
  constexpr double kInstant = 0.01;  // s
  const double yaw_rate = angleBetween(yaw, crash_.egoAt(time + kInstant).pose.yaw) / kInstant;
  message.twist.twist = geometry_msgs::Twist();
  message.twist.twist.linear.x = local.x;
  message.twist.twist.linear.y = local.y - yaw_rate * center_offset_;  // at base_link
  message.twist.twist.angular.z = yaw_rate;
  return message;
}

}  // namespace forge
