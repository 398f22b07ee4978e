#include "collision_forge/ros/bags/crash_topics.h"

#include <std_msgs/Float64.h>

#include <algorithm>
#include <boost/make_shared.hpp>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "collision_forge/ros/bags/bag_file.h"
#include "collision_forge/ros/bags/older_message.h"
#include "collision_forge/ros/markers/crash_scene.h"
#include "collision_forge/ros/messages/conversions.h"
#include "collision_forge/ros/messages/ros_bytes.h"

namespace forge {
namespace {

MadeType sceneType() { return {kSceneUpdateType, sceneUpdateDefinition(), kSceneUpdateMd5}; }

MadeType numberType() {
  namespace traits = ros::message_traits;
  return {traits::datatype<std_msgs::Float64>(), traits::definition<std_msgs::Float64>(),
          traits::md5sum<std_msgs::Float64>()};
}

std::string numberBytes(double value) {
  std::string bytes;
  appendRosBytes(bytes, value);
  return bytes;
}

/// Returns the attack; its report is replaced by `tested` if that belongs to it.
collision_forge::Attack knownAttack(const collision_forge::Attack& attack,
                                    const std::optional<collision_forge::CollisionReport>& tested) {
  collision_forge::Attack known = attack;
  if (tested && tested->header.stamp == attack.header.stamp &&
      tested->attacker_id == attack.trajectory.attacker_id) {
    known.report = *tested;
  }
  return known;
}

const collision_forge::Agent* agentIn(const collision_forge::AgentArray& agents,
                                      const std::string& id) {
  const auto found = std::find_if(agents.agents.begin(), agents.agents.end(),
                                  [&](const auto& agent) { return agent.id == id; });
  return found == agents.agents.end() ? nullptr : &*found;
}

}  // namespace

MadeTopic::MadeTopic(McapMessages& file, const char* name, MadeType type, bool latched)
    : file_(file), name_(name), type_(std::move(type)), is_latched_(latched) {}

void MadeTopic::write(const ros::Time& time, const std::string& message) {
  if (!number_) {
    std::map<std::string, std::string> header = {{"callerid", "/collision_forge"},
                                                 {"md5sum", type_.md5}};
    if (is_latched_) header["latching"] = "1";
    number_ = file_.addTopic(bagTopic(name_), type_.name, type_.definition, std::move(header));
  }
  file_.write(*number_, time, message);
}

CrashTopics::CrashTopics(McapMessages& file, const EgoVehicle& ego, const InputLimits& limits,
                         std::string agents)
    : ego_(ego),
      limits_(limits),
      agents_(std::move(agents)),
      scene_(file, names::kCrashScene, sceneType()),
      map_(file, names::kCrashMap, sceneType(), true),
      ego_speed_(file, names::kEgoSpeed, numberType()),
      attacker_speed_(file, names::kAttackerSpeed, numberType()) {}

void CrashTopics::take(const rosbag::MessageInstance& instance) {
  const std::string& topic = instance.getTopic();
  if (topic == names::kTf || topic == names::kStaticTf) {
    const auto transforms = instance.instantiate<tf2_msgs::TFMessage>();
    if (transforms) takeTransforms(*transforms, instance.getTime(), topic == names::kStaticTf);
  } else if (topic == agents_) {
    const auto agents = readMessage<collision_forge::AgentArray>(instance);
    if (agents) takeAgents(*agents, instance.getTime());
  } else if (topic == bagTopic(names::kLaneMap)) {
    const auto map = readMessage<collision_forge::LaneMap>(instance);
    if (map) takeMap(*map, instance.getTime());
  } else if (topic == bagTopic(names::kAttack)) {
    const auto attack = readMessage<collision_forge::Attack>(instance);
    if (attack) takeAttack(*attack);
  } else if (topic == bagTopic(names::kTestedReport)) {
    const auto tested = readMessage<collision_forge::CollisionReport>(instance);
    if (tested) tested_ = *tested;
  }
}

/// An attack without an attacker ends the current attack.
void CrashTopics::takeAttack(const collision_forge::Attack& attack) {
  attack_.reset();
  if (attack.trajectory.attacker_id.empty()) return;
  const auto check = [&] {
    checkTrajectory(fromMessage(attack.trajectory), limits_, names::kAttack);
  };
  if (isWithinLimits(names::kAttack, check)) attack_ = attack;
}

template <typename Check>
bool CrashTopics::isWithinLimits(const char* topic, const Check& check) {
  try {
    check();
    return true;
  } catch (const std::runtime_error&) {  // InputError, MessageError
    ++not_shown_[bagTopic(topic)];
    return false;
  }
}

bool CrashTopics::isShown(const collision_forge::Agent& agent) const {
  const double speed = std::hypot(agent.velocity.x, agent.velocity.y);
  return isWithin(fromMessage(agent.pose), limits_) &&
         isWithin(BoxSize{agent.size.x, agent.size.y}, limits_) && speed <= limits_.max_speed;
}

void CrashTopics::takeMap(const collision_forge::LaneMap& map, const ros::Time& time) {
  const auto check = [&] { checkMap(fromMessage(map), limits_, names::kLaneMap); };
  if (isWithinLimits(names::kLaneMap, check)) map_.write(time, toRosBytes(mapScene(map)));
}

void CrashTopics::takeAgents(collision_forge::AgentArray agents, const ros::Time& time) {
  auto& all = agents.agents;
  const auto shown_end =
      std::remove_if(all.begin(), all.end(), [this](const auto& agent) { return !isShown(agent); });
  if (shown_end != all.end()) not_shown_[agents_] += static_cast<int>(all.end() - shown_end);
  all.erase(shown_end, all.end());
  frames_.addFrame(boost::make_shared<Frame>(Frame{agents.header, time, std::move(agents)}));
  writePosed();
}

void CrashTopics::takeTransforms(const tf2_msgs::TFMessage& message, const ros::Time& time,
                                 bool is_static) {
  for (const geometry_msgs::TransformStamped& transform : message.transforms) {
    if (is_static || !places_.movesEgo(transform)) continue;
    places_.addFrame(boost::make_shared<Place>(Place{transform.header, time}));
  }
  places_.addTransforms(message, is_static);
  frames_.addTransforms(message, is_static);
  writePosed();
}

void CrashTopics::writePosed() {
  while (const auto posed = places_.next()) {
    showSpeed(*posed->message, fromMessage(posed->pose));
  }
  while (const auto posed = frames_.next()) show(*posed->message, fromMessage(posed->pose));
}

/// Writes the mean speed since the previous pose, unless that is older than kMaxGap.
void CrashTopics::showSpeed(const Place& place, const Pose2& base) {
  if (!isWithin(base, limits_)) {
    ++not_shown_[names::kTf];
    return;
  }
  const AgentState state{place.header.stamp.toSec(), base, Vector2::Zero()};
  const double duration = base_ ? state.time - base_->time : 0.0;
  if (duration > 0.0 && duration <= kMaxGap) {
    const double way = (base.position() - base_->pose.position()).norm();
    ego_speed_.write(place.time, numberBytes(way / duration));
  }
  base_ = state;
}

void CrashTopics::show(const Frame& frame, const Pose2& base) {
  if (!isWithin(base, limits_)) return;
  CrashView view;
  view.header = frame.header;
  view.ego = OrientedBox{compose(base, {ego_.center_offset, 0.0, 0.0}), ego_.size};
  std::optional<collision_forge::Attack> known;
  if (attack_ && frame.header.stamp >= attack_->header.stamp) {
    known = knownAttack(*attack_, tested_);
    view.attack = &*known;
    view.attacker = agentIn(frame.agents, known->trajectory.attacker_id);
  }
  scene_.write(frame.time, toRosBytes(crashScene(view, frame.agents)));
  if (!view.attacker) return;
  const auto& velocity = view.attacker->velocity;
  attacker_speed_.write(frame.time, numberBytes(std::hypot(velocity.x, velocity.y)));
}

std::vector<std::string> CrashTopics::warnings() const {
  std::vector<std::string> lines;
  for (const auto& [topic, count] : not_shown_) {
    lines.push_back(std::to_string(count) + " entries of " + topic +
                    " beyond the input limits are not shown");
  }
  return lines;
}

}  // namespace forge
