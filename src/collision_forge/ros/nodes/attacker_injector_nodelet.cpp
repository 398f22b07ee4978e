#include <ros/ros.h>
#include <pluginlib/class_list_macros.hpp>

#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include "collision_forge/io/batch/printable.h"
#include "collision_forge/ros/injection/live_injector.h"
#include "collision_forge/ros/messages/conversions.h"
#include "collision_forge/ros/messages/object_array.h"
#include "collision_forge/ros/messages/topic_names.h"
#include "collision_forge/ros/nodes/ego_poses.h"
#include "collision_forge/ros/nodes/node_support.h"
#include "collision_forge/ros/nodes/served_nodelet.h"

namespace forge {

/// agents -> injected_agents and injected_objects, with the newest attack in them (LiveInjector),
/// against the ego of /tf.
class AttackerInjectorNodelet : public QueuedNodelet {
 private:
  void start(ros::NodeHandle node) override {
    const Config config = loadNodeConfig(getPrivateNodeHandle());
    const auto choose = [this] { return nodeAfterContact(getPrivateNodeHandle()); };
    agents_ = node.advertise<collision_forge::AgentArray>(names::kInjectedAgents, kTopicQueue);
    objects_ = node.advertise<ObjectArray>(names::kInjectedObjects, kTopicQueue);
    injector_.emplace(config, loadLogged("choice", choose),
                      [this](const auto& agents) { publish(agents); });
    attack_subscriber_ =
        node.subscribe(names::kAttack, 1, &AttackerInjectorNodelet::receiveAttack, this);
    agents_subscriber_ =
        node.subscribe(names::kAgents, kTopicQueue, &AttackerInjectorNodelet::receiveAgents, this);
    ego_poses_ = std::make_unique<EgoPoses>(node, config.ego_vehicle,
                                            [this](const AgentState& ego, const BoxSize& size) {
                                              injector_->setEgoSize(size);
                                              injector_->addEgo(ego);
                                            });
  }

  void publish(const collision_forge::AgentArray& agents) {
    agents_.publish(agents);
    objects_.publish(toObjects(agents));
  }

  void receiveAttack(const collision_forge::Attack& message) {
    try {
      injector_->setAttack(message);
    } catch (const std::exception& error) {
      NODELET_ERROR_STREAM("attack ignored: " << printable(error.what()));
    }
  }

  void receiveAgents(const collision_forge::AgentArray::ConstPtr& message) {
    try {
      requireMapFrame(message->header, names::kAgents);
      injector_->addFrame(message);
    } catch (const std::exception& error) {
      NODELET_ERROR_STREAM_THROTTLE(1.0, "frame ignored: " << printable(error.what()));
    }
  }

  std::optional<LiveInjector> injector_;
  ros::Publisher agents_;
  ros::Publisher objects_;
  ros::Subscriber attack_subscriber_;
  ros::Subscriber agents_subscriber_;
  std::unique_ptr<EgoPoses> ego_poses_;
};

using ServedAttackerInjector = Served<AttackerInjectorNodelet>;

}  // namespace forge

PLUGINLIB_EXPORT_CLASS(forge::ServedAttackerInjector, nodelet::Nodelet)
