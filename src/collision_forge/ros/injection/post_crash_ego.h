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
  double ratio;  ///< position in time between the two, in (0, 1)
};

/// Rewrites the ego's transforms and odometry after the contact to its post-crash motion. Height,
/// roll and pitch are kept from the newest message before the contact. Messages must be passed in
/// the order of time.
class PostCrashEgo {
 public:
  /// Returns true for the transform map -> base_link.
  static bool isEgo(const geometry_msgs::TransformStamped& transform);

  /// `center_offset`: m, as in EgoVehicle.
  PostCrashEgo(const PostCrashMotion& crash, double center_offset);

  /// Returns `message` with map -> base_link rewritten after the contact; other transforms are
  /// kept.
  tf2_msgs::TFMessage changed(tf2_msgs::TFMessage message);
  nav_msgs::Odometry changed(nav_msgs::Odometry message);

  /// Returns an additional message at the contact if `next`, before it is passed to changed(), is
  /// the first message after the contact. Returns nullopt without an earlier message, or if either
  /// message has the stamp of the contact.
  std::optional<EgoBetween<tf2_msgs::TFMessage>> atContact(const tf2_msgs::TFMessage& next);
  std::optional<EgoBetween<nav_msgs::Odometry>> atContact(const nav_msgs::Odometry& next);

 private:
  std::optional<double> ratioOfContact(const ros::Time& before, const ros::Time& after) const;
  geometry_msgs::Pose poseAt(double time, const geometry_msgs::Pose& like) const;
  geometry_msgs::Transform transformAt(double time, const geometry_msgs::Transform& like) const;

  PostCrashMotion crash_;
  double center_offset_;
  std::optional<geometry_msgs::TransformStamped> last_transform_;  ///< newest up to the contact
  std::optional<nav_msgs::Odometry> last_odometry_;                ///< newest up to the contact
};

}  // namespace forge
