#include <collision_forge/AgentArray.h>
#include <collision_forge/Attack.h>
#include <collision_forge/AttackRequest.h>
#include <collision_forge/CollisionReport.h>
#include <ros/ros.h>
#include <pluginlib/class_list_macros.hpp>

#include <deque>
#include <memory>
#include <optional>

#include "collision_forge/attack/verify/ego_test.h"
#include "collision_forge/base/scene/scene_history.h"
#include "collision_forge/io/batch/printable.h"
#include "collision_forge/ros/bags/recorded_attack.h"
#include "collision_forge/ros/messages/conversions.h"
#include "collision_forge/ros/messages/topic_names.h"
#include "collision_forge/ros/nodes/ego_poses.h"
#include "collision_forge/ros/nodes/node_support.h"
#include "collision_forge/ros/nodes/served_nodelet.h"

namespace forge {

/// Verifies the newest attack against the driven ego (/tf) and publishes tested_report at the
/// contact, or at the end of the attacker's trajectory. An adaptive attack that is published again
/// continues its test. If the bag on replay (private parameter `recording`) contains the attack,
/// its stored report is published, which has the same values.
class AttackVerifierNodelet : public QueuedNodelet {
 private:
  static constexpr double kAhead = 1.0;  // s; agents of a new replay may come before its poses

  struct Frame {
    double time = 0.0;
    std::vector<Track> agents;
  };

  void start(ros::NodeHandle node) override {
    config_ = loadNodeConfig(getPrivateNodeHandle());
    map_ = std::make_unique<LaneMapSubscriber>(node, config_.input_limits);
    loadRecordedAttack(getPrivateNodeHandle().param<std::string>("recording", ""));
    publisher_ = node.advertise<collision_forge::CollisionReport>(names::kTestedReport, 1, true);
    subscribers_ = {
        node.subscribe(names::kAttack, 1, &AttackVerifierNodelet::receiveAttack, this),
        node.subscribe(names::kAttackRequest, 1, &AttackVerifierNodelet::receiveRequest, this),
        node.subscribe(names::kAgents, kTopicQueue, &AttackVerifierNodelet::receiveAgents, this)};
    ego_poses_ = std::make_unique<EgoPoses>(node, config_.ego_vehicle,
                                            [this](const AgentState& ego, const BoxSize& size) {
                                              config_.ego_vehicle.size = size;
                                              addEgo(ego);
                                            });
  }

  void loadRecordedAttack(const std::string& recording) {
    if (recording.empty()) return;
    try {
      recorded_ = readRecordedAttack(recording);
    } catch (const std::exception& error) {
      NODELET_ERROR_STREAM("recording not read: " << printable(error.what()));
    }
  }

  bool isOfRecording() const {
    return recorded_ && recorded_->tested_report.header.stamp == attack_->header.stamp &&
           recorded_->tested_report.attacker_id == attack_->trajectory.attacker_id;
  }

  void receiveAttack(const collision_forge::Attack& message) {
    const bool goes_on = isNextOf(message);
    attack_ = message;
    if (isNone(message)) {
      attack_.reset();
      test_.reset();
    } else if (!goes_on) {
      startTest();
    } else if (test_) {
      changeTest();
    }
  }

  /// Returns true if `message` is an update of the current adaptive attack.
  bool isNextOf(const collision_forge::Attack& message) const {
    return attack_ && attack_->adaptive && message.adaptive && message.plans > 1 &&
           attack_->header.stamp == message.header.stamp &&
           attack_->trajectory.attacker_id == message.trajectory.attacker_id;
  }

  /// Returns the attacker's trajectory. Throws MessageError and InputError.
  AttackerTrajectory trajectory() const {
    AttackerTrajectory trajectory = fromMessage(attack_->trajectory);
    checkTrajectory(trajectory, config_.input_limits, names::kAttack);
    return trajectory;
  }

  void changeTest() {
    try {
      test_->changeTrajectory(trajectory());
    } catch (const std::exception& error) {
      NODELET_ERROR_STREAM("attack ignored: " << printable(error.what()));
      test_.reset();
    }
  }

  /// Returns the request that defines success. If no request was received for the attack, derives
  /// it from the attack and the configured crash definition.
  CollisionRequest request() const {
    if (request_ && request_->header.stamp == attack_->header.stamp) {
      const auto own = fromMessage(request_->request, config_.crash);
      if (const auto* request = std::get_if<CollisionRequest>(&own)) return *request;
    }
    CollisionRequest request;
    request.type = fromMessage(attack_->pattern).type;
    request.tta = attack_->pattern.tta;
    request.crash = config_.crash;
    // A plausible attacker does these only if the request demands it.
    for (const Manoeuvre manoeuvre : {Manoeuvre::kWrongWay, Manoeuvre::kBackOut}) {
      if (attack_->report.manoeuvre == toString(manoeuvre)) request.manoeuvre = manoeuvre;
    }
    return request;
  }

  /// May arrive before or after its attack: the connections are separate.
  void receiveRequest(const collision_forge::AttackRequest& message) {
    request_ = message;
    if (test_) test_->changeRequest(request());
  }

  void startTest() {
    test_.reset();
    try {
      test_.emplace(trajectory(), request(), config_.ego_vehicle);
      for (const AgentState& ego : egos_) test_->addEgo(ego);
      for (const Frame& frame : frames_) test_->addAgents(frame.agents);
    } catch (const std::exception& error) {
      NODELET_ERROR_STREAM("attack ignored: " << printable(error.what()));
    }
  }

  void addEgo(const AgentState& ego) {
    if (!egos_.empty() && ego.time <= egos_.back().time) {
      // The replay restarted. An attack whose t0 is still ahead is tested again.
      egos_.clear();
      dropFramesAfter(ego.time + kAhead);
      test_.reset();
      if (attack_ && ego.time <= attack_->header.stamp.toSec()) startTest();
    }
    add(egos_, ego);
    if (!test_) return;
    test_->addEgo(ego);
    try {
      publishOutcome();
    } catch (const std::exception& error) {
      NODELET_ERROR_STREAM("attack ignored: " << printable(error.what()));
      test_.reset();
    }
  }

  void receiveAgents(const collision_forge::AgentArray& message) {
    const double time = message.header.stamp.toSec();
    if (!frames_.empty() && time <= frames_.back().time && time >= frames_.back().time - kRestart) {
      return;
    }
    try {
      requireMapFrame(message.header, names::kAgents);
      Frame frame{time, fromMessage(message)};
      keepWithin(frame.agents, config_.input_limits);
      dropFramesAfter(time);
      add(frames_, frame);
      if (test_) test_->addAgents(frame.agents);
    } catch (const std::exception& error) {
      NODELET_ERROR_STREAM_THROTTLE(1.0, "frame ignored: " << printable(error.what()));
    }
  }

  /// Drops frames after `time`, received before the replay went back.
  void dropFramesAfter(double time) {
    while (!frames_.empty() && frames_.back().time > time) frames_.pop_back();
  }

  template <typename Value>
  void add(std::deque<Value>& values, const Value& value) {
    values.push_back(value);
    keepNewest(values, config_.live.maxAttackAge());
  }

  void publishOutcome() {
    const auto lanes = map_->lanes();
    if (!lanes) return;
    const auto report = test_->outcome(*lanes, config_.attack.verification);
    if (!report) return;
    collision_forge::CollisionReport message =
        toMessage(*report, attack_->trajectory.attacker_id, attack_->header.stamp.toSec());
    message.decision = attack_->decision;
    publisher_.publish(isOfRecording() ? recorded_->tested_report : message);
    test_.reset();
  }

  Config config_;
  std::unique_ptr<LaneMapSubscriber> map_;
  std::optional<collision_forge::Attack> attack_;
  std::optional<collision_forge::AttackRequest> request_;  // the newest
  std::deque<AgentState> egos_;  // recent ones: an attack arrives after its t0
  std::deque<Frame> frames_;     // recent ones, of all other agents
  std::optional<EgoTest> test_;
  std::optional<RecordedAttack> recorded_;  // in the bag on replay
  ros::Publisher publisher_;
  std::vector<ros::Subscriber> subscribers_;
  std::unique_ptr<EgoPoses> ego_poses_;
};

using ServedAttackVerifier = Served<AttackVerifierNodelet>;

}  // namespace forge

PLUGINLIB_EXPORT_CLASS(forge::ServedAttackVerifier, nodelet::Nodelet)
