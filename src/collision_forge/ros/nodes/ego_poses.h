#pragma once

#include <collision_forge/EgoVehicle.h>
#include <geometry_msgs/TransformStamped.h>
#include <ros/ros.h>
#include <tf2_msgs/TFMessage.h>

#include <functional>
#include <vector>

#include "collision_forge/base/scene/scene.h"
#include "collision_forge/ros/messages/posed_frames.h"

namespace forge {

/// Tells where the middle of the ego's box is, as /tf comes: whenever that moves base_link, as soon
/// as its place in the map is known, whatever frames lie between. Velocities are zero. Times grow
/// but where a replay starts again, which they tell by going back by more than kRestart; what is
/// late or not finite is left out.
class EgoPoses {
 public:
  /// Receives the state of the ego's box and its size: that of the topic `ego_vehicle`, or else of
  /// the configured vehicle.
  using Callback = std::function<void(const AgentState& ego, const BoxSize& size)>;

  EgoPoses(ros::NodeHandle& node, const EgoVehicle& configured, Callback callback);

 private:
  void receive(const tf2_msgs::TFMessage& message);
  void receiveStatic(const tf2_msgs::TFMessage& message);
  void receiveVehicle(const collision_forge::EgoVehicle& message);
  void tell();

  EgoVehicle ego_;
  Callback callback_;
  PosedFrames<geometry_msgs::TransformStamped> poses_;
  double newest_;  // s
  std::vector<ros::Subscriber> subscribers_;
};

}  // namespace forge
