#include "collision_forge/attack/verify/ego_test.h"

#include <algorithm>
#include <stdexcept>

#include "collision_forge/base/scene/clock.h"
#include "collision_forge/base/scene/scene_history.h"

namespace forge {
namespace {

void append(Track& track, const AgentState& state) {
  if (track.states.empty() || state.time > track.states.back().time) track.states.push_back(state);
}

/// Returns the states of a track up to `now`, with velocities derived from its poses.
Track upTo(double now, Track track) {
  auto& states = track.states;
  const auto later = std::find_if(states.begin(), states.end(), [&](const AgentState& state) {
    return state.time > now + kTimeEpsilon;
  });
  states.erase(later, states.end());
  deriveVelocities(track);
  return track;
}

/// Returns true if later states cannot change the velocity at `time`: the state after `time` has a
/// successor, from which its velocity is derived.
bool isVelocityKnown(const Track& track, double time) {
  const auto& states = track.states;
  return states.size() >= 2 && states[states.size() - 2].time >= time;
}

}  // namespace

EgoTest::EgoTest(AttackerTrajectory trajectory, const CollisionRequest& request,
                 const EgoVehicle& ego)
    : request_(request), ego_{kEgoId, AgentClass::kCar, ego.size, {}} {
  changeTrajectory(std::move(trajectory));
}

void EgoTest::changeTrajectory(AttackerTrajectory trajectory) {
  if (trajectory.points.empty()) {
    throw std::invalid_argument("the trajectory of " + trajectory.attacker_id + " has no points");
  }
  trajectory_ = std::move(trajectory);
}

void EgoTest::addEgo(const AgentState& state) { append(ego_, state); }

void EgoTest::addAgents(const std::vector<Track>& agents) {
  for (const Track& agent : agents) {
    if (!isUsable(agent)) continue;
    Track& track =
        agents_
            .try_emplace(agent.id, Track{agent.id, agent.agent_class, agent.size, {}, agent.height})
            .first->second;
    for (const AgentState& state : agent.states) {
      append(track, state);
      agents_until_ = std::max(agents_until_, state.time);
    }
  }
}

std::optional<CollisionReport> EgoTest::outcome(const LaneIndex& lanes,
                                                const VerificationOptions& options) const {
  const double begin = trajectory_.points.front().time;
  if (ego_.states.empty() || ego_.states.front().time > begin + kTimeEpsilon) return std::nullopt;
  Future driven;
  driven.ego = ego_;
  deriveVelocities(driven.ego);
  for (const auto& [id, track] : agents_) driven.agents.push_back(track);
  Snapshot start;
  start.now = begin;
  const auto attacker = agents_.find(trajectory_.attacker_id);
  if (attacker != agents_.end()) {
    const Track past = upTo(start.now, attacker->second);
    if (endsAt(past, start.now)) start.agents.push_back(past);
  }
  const CollisionReport report = verify(trajectory_, {start, driven, request_, lanes}, options);
  const bool ended = ego_.states.back().time >= trajectory_.points.back().time;
  const bool touched = report.contact && agents_until_ >= report.contact_time &&
                       isVelocityKnown(ego_, report.contact_time);
  if (ended || touched) return report;
  return std::nullopt;
}

}  // namespace forge
