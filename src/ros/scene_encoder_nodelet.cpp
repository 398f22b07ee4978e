#include <collision_forge/AgentArray.h>
#include <collision_forge/EncodedScene.h>
#include <nodelet/nodelet.h>
#include <ros/ros.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/message_filter.h>
#include <tf2_ros/transform_listener.h>
#include <pluginlib/class_list_macros.hpp>

#include <message_filters/subscriber.h>

#include <optional>

#include "network/scene_encoding.h"
#include "ros/conversions.h"
#include "ros/node_support.h"
#include "ros/topic_names.h"
#include "scene/scene_history.h"

namespace forge {

/// agents + lane_map + tf -> encoded_scene, once a frame of agents.
class SceneEncoderNodelet : public nodelet::Nodelet {
 private:
  static constexpr int kQueue = 100;  // frames that may wait for their transform

  void onInit() override {
    config_ = loadNodeConfig(getPrivateNodeHandle());
    history_.emplace(config_.attack.prediction.history_frames, config_.ego_vehicle);
    ros::NodeHandle& node = getNodeHandle();
    map_ = std::make_unique<LaneMapSubscriber>(node);
    publisher_ = node.advertise<collision_forge::EncodedScene>(names::kEncodedScene, kQueue);
    // In this node's own queue: tf2's MessageFilter loses a message whose transform comes from
    // another thread while it is being put aside (seen: 1 frame in 10,000).
    constexpr bool kOwnThread = false;
    listener_ = std::make_unique<tf2_ros::TransformListener>(buffer_, node, kOwnThread);
    agents_.subscribe(node, names::kAgents, kQueue);
    filter_ = std::make_unique<tf2_ros::MessageFilter<collision_forge::AgentArray>>(
        agents_, buffer_, names::kBaseFrame, kQueue, node);
    filter_->registerCallback(&SceneEncoderNodelet::receive, this);
  }

  void receive(const collision_forge::AgentArray::ConstPtr& message) {
    try {
      addFrame(*message);
      publish();
    } catch (const std::exception& error) {
      NODELET_ERROR_STREAM_THROTTLE(
          1.0, "frame at " << message->header.stamp << " left out: " << error.what());
    }
  }

  void addFrame(const collision_forge::AgentArray& message) {
    const auto transform =
        buffer_.lookupTransform(names::kMapFrame, names::kBaseFrame, message.header.stamp);
    Frame frame;
    frame.time = message.header.stamp.toSec();
    frame.ego =
        compose(fromMessage(transform.transform), {config_.ego_vehicle.center_offset, 0.0, 0.0});
    frame.agents = fromMessage(message);
    if (const int dropped = history_->add(std::move(frame))) {
      NODELET_WARN_STREAM_THROTTLE(1.0, dropped << " agents at " << message.header.stamp
                                                << " are not a number or have no size");
    }
  }

  void publish() {
    const auto lanes = map_->lanes();
    if (!lanes) {
      NODELET_WARN_STREAM_THROTTLE(5.0, "no usable lane_map yet");
      return;
    }
    const Snapshot snapshot = history_->snapshot();
    publisher_.publish(toMessage(
        snapshot,
        encodeScene(snapshot, *lanes, config_.attack.prediction.history_frames, config_.encoding)));
  }

  Config config_;
  std::optional<SceneHistory> history_;
  std::unique_ptr<LaneMapSubscriber> map_;
  ros::Publisher publisher_;
  tf2_ros::Buffer buffer_;
  std::unique_ptr<tf2_ros::TransformListener> listener_;
  message_filters::Subscriber<collision_forge::AgentArray> agents_;
  std::unique_ptr<tf2_ros::MessageFilter<collision_forge::AgentArray>> filter_;
};

}  // namespace forge

PLUGINLIB_EXPORT_CLASS(forge::SceneEncoderNodelet, nodelet::Nodelet)
