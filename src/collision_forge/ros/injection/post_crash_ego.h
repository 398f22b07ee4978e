#pragma once

#include <geometry_msgs/Pose.h>
#include <geometry_msgs/TransformStamped.h>
#include <nav_msgs/Odometry.h>
#include <tf2_msgs/TFMessage.h>

#include <optional>
#include <vector>

#include "collision_forge/attack/verify/post_crash_motion.h"

namespace forge {

/// A message of the ego to insert between two recorded ones.
template <typename Message>
struct EgoBetween {
  Message message;
  double ratio;  ///< share, in (0, 1), of the time from the earlier message to the later one
};

/// Rewrites the ego's transforms and odometry after the contact to its post-crash motion. Height,
/// roll and pitch are kept from the newest message up to the contact, or from the message itself if
/// there is none. Messages must be passed in the order of their header stamps, transforms and
/// odometry independently of each other.
class PostCrashEgo {
 public:
  /// Returns true for the transform map -> base_link (the ego's base_link, not its box centre).
  static bool isEgo(const geometry_msgs::TransformStamped& transform);

  /// `center_offset`: m, as in EgoVehicle.
  PostCrashEgo(const PostCrashMotion& crash, double center_offset);

  /// Returns `message` with map -> base_link rewritten after the contact; other transforms are
  /// kept.
  tf2_msgs::TFMessage changed(tf2_msgs::TFMessage message);
  /// Returns `message` with pose and twist (both of base_link, the twist in its frame) rewritten
  /// after the contact; before it the message is kept.
  nav_msgs::Odometry changed(nav_msgs::Odometry message);

  /// Returns an additional message at the contact, with only the transform map -> base_link at the
  /// ego's pose there, if `next`, which is yet to be passed to changed(), is the first message
  /// after the contact. Returns nullopt if it is not, without an earlier message, and if either
  /// message has the stamp of the contact.
  std::optional<EgoBetween<tf2_msgs::TFMessage>> atContact(const tf2_msgs::TFMessage& next);
  /// Does the same for odometry; the twist is interpolated between the two messages.
  std::optional<EgoBetween<nav_msgs::Odometry>> atContact(const nav_msgs::Odometry& next);

 private:
  /// Returns the share of the time between two stamps at which the contact is; nullopt if it is not
  /// between them.
  std::optional<double> ratioOfContact(const ros::Time& before, const ros::Time& after) const;
  /// Returns the pose of base_link after the contact at `time`, s, with height, roll and pitch of
  /// `like`.
  geometry_msgs::Pose poseAt(double time, const geometry_msgs::Pose& like) const;
  geometry_msgs::Transform transformAt(double time, const geometry_msgs::Transform& like) const;

  PostCrashMotion crash_;
  double center_offset_;                                           ///< m
  std::optional<geometry_msgs::TransformStamped> last_transform_;  ///< newest up to the contact
  std::optional<nav_msgs::Odometry> last_odometry_;                ///< newest up to the contact
};

}  // namespace forge
