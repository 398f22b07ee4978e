#include <nodelet/nodelet.h>
#include <ros/ros.h>
#include <pluginlib/class_list_macros.hpp>

#include <optional>

#include "collision_forge/ros/conversions.h"
#include "collision_forge/ros/injection.h"
#include "collision_forge/ros/node_support.h"
#include "collision_forge/ros/topic_names.h"

namespace forge {

/// agents -> injected_agents, with the newest attacker's trajectory in place of its recorded
/// future. A replay that is restarted before the attack's start passes the recording through until
/// then.
class AttackerInjectorNodelet : public nodelet::Nodelet {
 private:
  void onInit() override {
    ros::NodeHandle& node = getNodeHandle();
    publisher_ = node.advertise<collision_forge::AgentArray>(names::kInjectedAgents, kTopicQueue);
    attack_subscriber_ =
        node.subscribe(names::kAttack, 1, &AttackerInjectorNodelet::receiveAttack, this);
    agents_subscriber_ =
        node.subscribe(names::kAgents, kTopicQueue, &AttackerInjectorNodelet::receiveAgents, this);
  }

  void receiveAttack(const collision_forge::Attack& message) {
    if (isNone(message)) {
      injector_.reset();
      return;
    }
    try {
      static_cast<void>(fromMessage(message.trajectory));  // as the injector will for every frame
    } catch (const MessageError& error) {
      NODELET_ERROR_STREAM("attack left out: " << error.what());
      return;
    }
    if (injector_ && injector_->change(message.trajectory)) return;
    injector_.emplace(message.trajectory);
    if (last_) injector_->remember(*last_);
  }

  void receiveAgents(const collision_forge::AgentArray::ConstPtr& message) {
    last_ = message;
    publisher_.publish(injector_ ? injector_->inject(*message) : *message);
  }

  std::optional<AttackerInjector> injector_;
  collision_forge::AgentArray::ConstPtr last_;  // tells the injector the attacker's height
  ros::Publisher publisher_;
  ros::Subscriber attack_subscriber_;
  ros::Subscriber agents_subscriber_;
};

}  // namespace forge

PLUGINLIB_EXPORT_CLASS(forge::AttackerInjectorNodelet, nodelet::Nodelet)
