#include <nodelet/nodelet.h>
#include <ros/ros.h>
#include <pluginlib/class_list_macros.hpp>

#include <optional>

#include "collision_forge/ros/attacker_injector.h"
#include "collision_forge/ros/conversions.h"
#include "collision_forge/ros/node_support.h"
#include "collision_forge/ros/topic_names.h"

namespace forge {

/// agents -> injected_agents, with the newest attacker's trajectory in place of its recorded
/// future; at its end it brakes to a stand and stays. A replay that is restarted before the
/// attack's start passes the recording through until then.
class AttackerInjectorNodelet : public nodelet::Nodelet {
 private:
  void onInit() override {
    const auto load = [this] { return loadNodeConfig(getPrivateNodeHandle()); };
    limits_ = loadLogged("configuration", load).attack.verification.drivable;
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
      inject(message.trajectory, slideFromEnd(fromMessage(message.trajectory), limits_));
    } catch (const MessageError& error) {
      NODELET_ERROR_STREAM("attack left out: " << error.what());
    }
  }

  void inject(const collision_forge::AttackerTrajectory& trajectory, const BrakingSlide& slide) {
    if (injector_ && injector_->change(trajectory, slide)) return;
    injector_.emplace(trajectory, slide);
    if (last_) injector_->remember(*last_);
  }

  void receiveAgents(const collision_forge::AgentArray::ConstPtr& message) {
    last_ = message;
    publisher_.publish(injector_ ? injector_->inject(*message) : *message);
  }

  DriveLimitOptions limits_;
  std::optional<AttackerInjector> injector_;
  collision_forge::AgentArray::ConstPtr last_;  // tells the injector the attacker's height
  ros::Publisher publisher_;
  ros::Subscriber attack_subscriber_;
  ros::Subscriber agents_subscriber_;
};

}  // namespace forge

PLUGINLIB_EXPORT_CLASS(forge::AttackerInjectorNodelet, nodelet::Nodelet)
