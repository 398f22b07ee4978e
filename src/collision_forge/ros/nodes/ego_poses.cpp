#include "collision_forge/ros/nodes/ego_poses.h"

#include <boost/make_shared.hpp>
#include <limits>
#include <utility>

#include "collision_forge/ros/messages/conversions.h"
#include "collision_forge/ros/messages/topic_names.h"
#include "collision_forge/ros/nodes/node_support.h"

namespace forge {

EgoPoses::EgoPoses(ros::NodeHandle& node, const EgoVehicle& configured, Callback callback)
    : ego_(configured),
      callback_(std::move(callback)),
      newest_(-std::numeric_limits<double>::infinity()) {
  subscribers_ = {node.subscribe(names::kTf, kTopicQueue, &EgoPoses::receive, this),
                  node.subscribe(names::kStaticTf, kTopicQueue, &EgoPoses::receiveStatic, this),
                  node.subscribe(names::kEgoVehicle, 1, &EgoPoses::receiveVehicle, this)};
}

void EgoPoses::receive(const tf2_msgs::TFMessage& message) {
  for (const geometry_msgs::TransformStamped& transform : message.transforms) {
    if (poses_.movesEgo(transform)) {
      poses_.addFrame(boost::make_shared<geometry_msgs::TransformStamped>(transform));
    }
  }
  poses_.addTransforms(message, false);
  reportPoses();
}

void EgoPoses::receiveStatic(const tf2_msgs::TFMessage& message) {
  poses_.addTransforms(message, true);
  reportPoses();
}

void EgoPoses::receiveVehicle(const collision_forge::EgoVehicle& message) {
  ego_.size = egoSizeOf(message).value_or(ego_.size);
}

void EgoPoses::reportPoses() {
  while (const auto posed = poses_.next()) {
    const double time = posed->message->header.stamp.toSec();
    const Pose2 middle = compose(fromMessage(posed->pose), {ego_.center_offset, 0.0, 0.0});
    const bool is_late = time <= newest_ && time >= newest_ - kRestart;
    if (is_late || !middle.isFinite()) continue;
    newest_ = time;
    callback_({time, middle, Vector2::Zero()}, ego_.size);
  }
}

}  // namespace forge
