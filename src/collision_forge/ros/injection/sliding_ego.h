#pragma once

#include <geometry_msgs/Pose.h>
#include <geometry_msgs/TransformStamped.h>
#include <nav_msgs/Odometry.h>
#include <tf2_msgs/TFMessage.h>

#include <optional>
#include <vector>

#include "collision_forge/attack/verify/post_crash_motion.h"

namespace forge {

/// A message between two recorded ones.
template <typename Message>
struct EgoBetween {
  Message message;
  double ratio;  ///< of the time between the two, in (0, 1)
};

/// Rewrites the ego's transforms and odometry in a recording, from the contact on. Height, roll and
/// pitch stay those of the newest message up to then. Messages come in the order of time.
class SlidingEgo {
 public:
  /// Returns true if the transform is map -> base_link.
  static bool isEgo(const geometry_msgs::TransformStamped& transform);

  /// `center_offset` as of EgoVehicle.
  SlidingEgo(const PostCrashMotion& crash, double center_offset);

  /// Returns the message with the ego's post-crash pose; keeps other transforms.
  tf2_msgs::TFMessage changed(tf2_msgs::TFMessage message);
  nav_msgs::Odometry changed(nav_msgs::Odometry message);

  /// The ego at the contact, for the first message that comes after that, before it is changed().
  /// Nothing where there was none before, or where one of the two has that stamp.
  std::optional<EgoBetween<tf2_msgs::TFMessage>> atContact(const tf2_msgs::TFMessage& next);
  std::optional<EgoBetween<nav_msgs::Odometry>> atContact(const nav_msgs::Odometry& next);

 private:
  std::optional<double> ratioOfContact(const ros::Time& before, const ros::Time& after) const;
  geometry_msgs::Pose poseAt(double time, const geometry_msgs::Pose& like) const;
  geometry_msgs::Transform transformAt(double time, const geometry_msgs::Transform& like) const;

  PostCrashMotion crash_;
  double center_offset_;
  std::optional<geometry_msgs::TransformStamped> last_transform_;  ///< up to then, as is the next
  std::optional<nav_msgs::Odometry> last_odometry_;
};

}  // namespace forge
