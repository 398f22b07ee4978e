#include "collision_forge/ros/injection/attacker_injector.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "collision_forge/attack/verify/braking_slide.h"
#include "collision_forge/ros/messages/conversions.h"

namespace forge {
namespace {

/// Returns the state of an added attacker at a time in its past; empty outside of it.
std::optional<AgentState> pastAt(const collision_forge::AttackerTrajectory& trajectory,
                                 double time) {
  Track past;
  for (const auto& state : trajectory.past) past.states.push_back(fromMessage(state));
  return stateAt(past, time);
}

}  // namespace

AttackerInjector::AttackerInjector(collision_forge::AttackerTrajectory trajectory,
                                   const DriveLimitOptions& options, AfterEnd after_end)
    : trajectory_(std::move(trajectory)), options_(options), after_end_(after_end) {
  attacker_.id = trajectory_.attacker_id;
  attacker_.agent_class = trajectory_.agent_class;
  attacker_.size = trajectory_.size;
}

bool AttackerInjector::change(const collision_forge::AttackerTrajectory& trajectory) {
  const bool is_same = trajectory.attacker_id == trajectory_.attacker_id &&
                       trajectory.header.stamp == trajectory_.header.stamp &&
                       trajectory.agent_class == trajectory_.agent_class &&
                       trajectory.size == trajectory_.size && trajectory.past == trajectory_.past;
  if (!is_same) return false;
  trajectory_ = trajectory;
  return true;
}

void AttackerInjector::remember(const collision_forge::AgentArray& recorded) {
  for (const collision_forge::Agent& agent : recorded.agents) {
    if (agent.id != attacker_.id) continue;
    attacker_ = agent;
    attacker_.agent_class = trajectory_.agent_class;
    is_remembered_ = true;
  }
  if (!trajectory_.past.empty() && !is_remembered_) rememberLike(recorded);
}

/// Takes the ground of an added attacker from the nearest motor vehicle or agent of its class.
void AttackerInjector::rememberLike(const collision_forge::AgentArray& recorded) {
  const Pose2 now = forge::fromMessage(trajectory_.past.back().pose);
  const auto distanceOf = [&](const collision_forge::Agent& agent) {
    return (forge::fromMessage(agent.pose).position() - now.position()).norm();
  };
  const collision_forge::Agent* nearest = nullptr;
  for (const collision_forge::Agent& agent : recorded.agents) {
    const bool is_vehicle = agent.agent_class <= collision_forge::Agent::SCOOTER &&
                            (agent.agent_class == attacker_.agent_class ||
                             isMotorVehicle(static_cast<AgentClass>(agent.agent_class)));
    if (is_vehicle && (!nearest || distanceOf(agent) < distanceOf(*nearest))) nearest = &agent;
  }
  if (!nearest) return;
  const BoxSize size{attacker_.size.x, attacker_.size.y};
  attacker_.size.z = typicalHeight(static_cast<AgentClass>(attacker_.agent_class), size);
  const double ground = nearest->pose.position.z - 0.5 * nearest->size.z;
  attacker_.pose.position.z = ground + 0.5 * attacker_.size.z;
  is_remembered_ = true;
}

bool AttackerInjector::hasLeft(const ros::Time& stamp) const {
  if (after_end_ != AfterEnd::kLeave) return false;
  const auto& last = trajectory_.points.back();
  return stamp > last.stamp && last.speed != 0.0;
}

/// Replaces the recorded attacker, or adds it if the frame lacks it.
void AttackerInjector::put(const AgentState& state, collision_forge::AgentArray& agents) const {
  collision_forge::Agent attacker = attacker_;
  attacker.pose = toPoseMessage(state.pose);
  attacker.pose.position.z = attacker_.pose.position.z;
  attacker.velocity.x = state.velocity.x();
  attacker.velocity.y = state.velocity.y();
  attacker.velocity.z = 0.0;
  auto& all = agents.agents;
  const auto attacks = [&](const collision_forge::Agent& agent) { return agent.id == attacker.id; };
  const auto recorded = std::find_if(all.begin(), all.end(), attacks);
  if (recorded == all.end()) {
    all.push_back(attacker);
    return;
  }
  *recorded = attacker;
  all.erase(std::remove_if(std::next(recorded), all.end(), attacks), all.end());
}

AgentState AttackerInjector::stateAfterNow(double time) const {
  if (crash_ && time > crash_->contactTime()) return crash_->attackerAt(time);
  const AttackerTrajectory trajectory = fromMessage(trajectory_);
  const TrajectoryPoint point = pointAt(trajectory.points, time);
  const StraightBraking braking = brakingFromEnd(trajectory, options_);
  if (time > braking.begin) return braking.stateFrom(point.pose, time);
  return {time, point.pose, point.speed * point.pose.heading()};
}

collision_forge::AgentArray AttackerInjector::inject(collision_forge::AgentArray agents) {
  const double time = agents.header.stamp.toSec();
  if (trajectory_.points.empty() || agents.header.stamp <= trajectory_.points.front().stamp) {
    remember(agents);
    const auto before = pastAt(trajectory_, time);
    if (before) put(*before, agents);
    return agents;
  }
  if (hasLeft(agents.header.stamp)) {
    auto& all = agents.agents;
    const auto has_its_id = [this](const auto& agent) { return agent.id == attacker_.id; };
    all.erase(std::remove_if(all.begin(), all.end(), has_its_id), all.end());
    return agents;
  }
  if (!is_remembered_) remember(agents);
  put(stateAfterNow(time), agents);
  return agents;
}

}  // namespace forge
