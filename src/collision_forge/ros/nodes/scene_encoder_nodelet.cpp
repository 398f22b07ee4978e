#include <collision_forge/AgentArray.h>
#include <collision_forge/EgoVehicle.h>
#include <collision_forge/EncodedScene.h>
#include <ros/ros.h>
#include <tf2_msgs/TFMessage.h>
#include <boost/make_shared.hpp>
#include <pluginlib/class_list_macros.hpp>

#include <optional>
#include <stdexcept>

#include "collision_forge/attack/network/scene_encoding.h"
#include "collision_forge/base/scene/scene_history.h"
#include "collision_forge/io/batch/printable.h"
#include "collision_forge/ros/messages/conversions.h"
#include "collision_forge/ros/messages/posed_frames.h"
#include "collision_forge/ros/messages/topic_names.h"
#include "collision_forge/ros/nodes/node_support.h"
#include "collision_forge/ros/nodes/served_nodelet.h"

namespace forge {

/// Publishes encoded_scene from agents, lane_map and /tf, once per frame of agents.
class SceneEncoderNodelet : public QueuedNodelet {
 private:
  static constexpr int kPublished = 100;  // scenes queued for a slow subscriber; each is large

  void start(ros::NodeHandle node) override {
    config_ = loadNodeConfig(getPrivateNodeHandle());
    history_.emplace(config_.attack.prediction.history_frames, config_.ego_vehicle);
    map_ = std::make_unique<LaneMapSubscriber>(node, config_.input_limits, [this] { encode(); });
    publisher_ = node.advertise<collision_forge::EncodedScene>(names::kEncodedScene, kPublished);
    subscribers_ = {
        node.subscribe(names::kTf, kTopicQueue, &SceneEncoderNodelet::receiveTransforms, this),
        node.subscribe(names::kStaticTf, kTopicQueue, &SceneEncoderNodelet::receiveStaticTransforms,
                       this),
        node.subscribe(names::kEgoVehicle, 1, &SceneEncoderNodelet::receiveEgoVehicle, this),
        node.subscribe(names::kAgents, kTopicQueue, &SceneEncoderNodelet::receiveAgents, this)};
  }

  void receiveTransforms(const tf2_msgs::TFMessage& message) {
    frames_.addTransforms(message, false);
    encode();
  }

  void receiveStaticTransforms(const tf2_msgs::TFMessage& message) {
    frames_.addTransforms(message, true);
    encode();
  }

  void receiveEgoVehicle(const collision_forge::EgoVehicle& message) {
    if (const auto size = egoSizeOf(message)) history_->setEgoSize(*size);
  }

  void receiveAgents(const collision_forge::AgentArray::ConstPtr& message) {
    frames_.addFrame(message);
    if (!map_->lanes()) {
      NODELET_WARN_STREAM_THROTTLE(5.0, "no usable lane_map yet: frames wait for it");
    }
    encode();
  }

  /// Processes the frames whose transform and map have arrived (separate connections).
  void encode() {
    const auto lanes = map_->lanes();
    if (!lanes) return;
    while (const auto frame = frames_.next()) {
      if (frame->dropped > 0) {
        NODELET_WARN_STREAM_THROTTLE(1.0, frame->dropped << " frames before "
                                                         << frame->message->header.stamp
                                                         << " left out: no transform received");
      }
      try {
        add(*frame);
        publish(*lanes);
      } catch (const std::exception& error) {
        NODELET_ERROR_STREAM_THROTTLE(1.0, "frame at " << frame->message->header.stamp
                                                       << " left out: " << printable(error.what()));
      }
    }
  }

  void add(const PosedFrames<collision_forge::AgentArray>::PosedFrame& posed) {
    const collision_forge::AgentArray& message = *posed.message;
    requireMapFrame(message.header, names::kAgents);
    Frame frame;
    frame.time = message.header.stamp.toSec();
    if (history_->isLate(frame.time)) {
      throw std::invalid_argument("its stamp is not later than the previous one");
    }
    frame.ego = compose(fromMessage(posed.pose), {config_.ego_vehicle.center_offset, 0.0, 0.0});
    if (!isWithin(frame.ego, config_.input_limits)) {
      throw std::invalid_argument("the ego's pose is beyond the input limits");
    }
    frame.agents = fromMessage(message);
    std::vector<std::string> warnings;
    keepWithin(frame.agents, config_.input_limits, &warnings);
    for (const std::string& warning : warnings) {
      NODELET_WARN_STREAM_THROTTLE(1.0, names::kAgents << ": " << printable(warning));
    }
    if (const int dropped = history_->add(std::move(frame))) {
      NODELET_WARN_STREAM_THROTTLE(1.0, dropped << " agents at " << message.header.stamp
                                                << " are not finite or have no size");
    }
  }

  void publish(const LaneIndex& lanes) {
    const Snapshot snapshot = history_->snapshot();
    const SceneEncoding encoding =
        encodeScene(snapshot, lanes, config_.attack.prediction.history_frames, config_.encoding);
    // Published as a pointer: nodelets of one process share the message.
    publisher_.publish(
        boost::make_shared<const collision_forge::EncodedScene>(toMessage(snapshot, encoding)));
  }

  Config config_;
  std::optional<SceneHistory> history_;
  std::unique_ptr<LaneMapSubscriber> map_;
  ros::Publisher publisher_;
  PosedFrames<collision_forge::AgentArray> frames_;
  std::vector<ros::Subscriber> subscribers_;
};

using ServedSceneEncoder = Served<SceneEncoderNodelet>;

}  // namespace forge

PLUGINLIB_EXPORT_CLASS(forge::ServedSceneEncoder, nodelet::Nodelet)
