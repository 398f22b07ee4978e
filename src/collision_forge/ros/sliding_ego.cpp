#include "collision_forge/ros/sliding_ego.h"

#include "collision_forge/ros/conversions.h"
#include "collision_forge/ros/topic_names.h"

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

SlidingEgo::SlidingEgo(const BrakingSlide& slide, const Pose2& box, double center_offset)
    : slide_(slide), base_(compose(box, {-center_offset, 0.0, 0.0})) {}

geometry_msgs::Pose SlidingEgo::poseAt(double time, const geometry_msgs::Pose& like) const {
  geometry_msgs::Pose pose = like;
  setPlanar(slide_.stateFrom(base_, time).pose, pose);
  return pose;
}

tf2_msgs::TFMessage SlidingEgo::changed(tf2_msgs::TFMessage message) {
  for (auto& transform : message.transforms) {
    const bool is_ego = transform.header.frame_id == names::kMapFrame &&
                        transform.child_frame_id == names::kBaseFrame;
    if (!is_ego) continue;
    const double time = transform.header.stamp.toSec();
    if (time <= slide_.begin) {
      last_transform_ = transform.transform;
      continue;
    }
    const geometry_msgs::Pose pose =
        poseAt(time, poseOf(last_transform_.value_or(transform.transform)));
    transform.transform.translation.x = pose.position.x;
    transform.transform.translation.y = pose.position.y;
    transform.transform.translation.z = pose.position.z;
    transform.transform.rotation = pose.orientation;
  }
  return message;
}

nav_msgs::Odometry SlidingEgo::changed(nav_msgs::Odometry message) {
  const double time = message.header.stamp.toSec();
  if (time <= slide_.begin) {
    last_pose_ = message.pose.pose;
    return message;
  }
  message.pose.pose = poseAt(time, last_pose_.value_or(message.pose.pose));
  const Vector2 velocity = slide_.stateFrom(base_, time).velocity;
  const Pose2 local = relativeTo({0.0, 0.0, base_.yaw}, {velocity.x(), velocity.y(), base_.yaw});
  message.twist.twist = geometry_msgs::Twist();
  message.twist.twist.linear.x = local.x;
  message.twist.twist.linear.y = local.y;
  return message;
}

}  // namespace forge
