#pragma once

#include <geometry_msgs/Pose.h>
#include <nav_msgs/Odometry.h>
#include <tf2_msgs/TFMessage.h>

#include <optional>

#include "collision_forge/verify/braking_slide.h"

namespace forge {

/// Rewrites what tells the ego's motion in a recording, from the beginning of a slide on. Height,
/// roll and pitch stay those of the newest message up to then. Messages come in the order of time.
class SlidingEgo {
 public:
  /// `box` is the ego's box when the slide begins, `center_offset` as of EgoVehicle.
  SlidingEgo(const BrakingSlide& slide, const Pose2& box, double center_offset);

  /// The same with map -> base_link as it slides; other transforms are left alone.
  tf2_msgs::TFMessage changed(tf2_msgs::TFMessage message);
  nav_msgs::Odometry changed(nav_msgs::Odometry message);

 private:
  geometry_msgs::Pose poseAt(double time, const geometry_msgs::Pose& like) const;

  BrakingSlide slide_;
  Pose2 base_;                                              ///< base_link when the slide begins
  std::optional<geometry_msgs::Transform> last_transform_;  ///< up to then, as is the next
  std::optional<geometry_msgs::Pose> last_pose_;
};

}  // namespace forge
