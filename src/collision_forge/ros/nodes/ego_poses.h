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

/// Subscribes to /tf, /tf_static and ego_vehicle, and reports each new pose of the ego's box middle
/// in the map frame, through any chain of frames to base_link. Velocities are zero. Times are the
/// stamps of the transforms that move the ego (EgoMovers), s; they increase, except that a step
/// back by more than kRestart means that the replay restarted. Non-finite poses, and poses at most
/// kRestart older than the newest or as old, are dropped.
class EgoPoses {
 public:
  /// Receives the state of the ego's box and its size (m), from the topic `ego_vehicle` or else
  /// from the configuration.
  using Callback = std::function<void(const AgentState& ego, const BoxSize& size)>;

  /// Calls `callback` in the thread that receives /tf and /tf_static, once per pose. `configured`:
  /// size until a valid ego_vehicle arrives (egoSizeOf()), and always the offset from base_link to
  /// the box middle.
  EgoPoses(ros::NodeHandle& node, const EgoVehicle& configured, Callback callback);

 private:
  void receive(const tf2_msgs::TFMessage& message);
  void receiveStatic(const tf2_msgs::TFMessage& message);
  void receiveVehicle(const collision_forge::EgoVehicle& message);
  void reportPoses();

  EgoVehicle ego_;
  Callback callback_;
  PosedFrames<geometry_msgs::TransformStamped> poses_;  // of the transforms that move the ego
  double newest_;  // s, time of the last reported pose; minus infinity before the first
  std::vector<ros::Subscriber> subscribers_;
};

}  // namespace forge
