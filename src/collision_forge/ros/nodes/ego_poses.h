#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <ros/ros.h>
#include <tf2_msgs/TFMessage.h>

#include <functional>
#include <vector>

#include "collision_forge/base/scene/track.h"
#include "collision_forge/ros/messages/posed_frames.h"

namespace forge {

/// Tells where the middle of the ego's box is, as /tf comes: whenever that moves base_link, as soon
/// as its place in the map is known, whatever frames lie between. Velocities are zero. Times grow
/// but where a replay starts again, which they tell by going back by more than kRestart; what is
/// late or not finite is left out.
class EgoPoses {
 public:
  using Callback = std::function<void(const AgentState& ego)>;

  /// `center_offset` as of EgoVehicle.
  EgoPoses(ros::NodeHandle& node, double center_offset, Callback callback);

 private:
  void receive(const tf2_msgs::TFMessage& message);
  void receiveStatic(const tf2_msgs::TFMessage& message);
  void tell();

  double center_offset_;
  Callback callback_;
  PosedFrames<geometry_msgs::TransformStamped> poses_;
  double newest_;  // s
  std::vector<ros::Subscriber> subscribers_;
};

}  // namespace forge
