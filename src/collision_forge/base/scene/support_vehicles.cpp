#include "collision_forge/base/scene/support_vehicles.h"

#include <algorithm>
#include <utility>

#include "collision_forge/base/scene/clock.h"
#include "collision_forge/base/scene/find_track.h"

namespace forge {
namespace {

/// Puts the track in the place of the agent with its id, or at the end.
void replace(std::vector<Track>& agents, Track track) {
  const auto same = std::find_if(agents.begin(), agents.end(),
                                 [&](const Track& agent) { return agent.id == track.id; });
  if (same == agents.end()) {
    agents.push_back(std::move(track));
  } else {
    *same = std::move(track);
  }
}

}  // namespace

Track trackOf(const SupportVehicle& support, const Track* recorded, double end) {
  const AttackerTrajectory& motion = support.motion;
  Track track{motion.attacker_id, motion.agent_class, motion.size, motion.past};
  if (recorded && !motion.isAdded()) {
    track.states = recorded->states;
    track.height = recorded->height;
  }
  const double begin = motion.points.front().time - kTimeEpsilon;
  auto& states = track.states;
  states.erase(std::find_if(states.begin(), states.end(),
                            [=](const AgentState& state) { return state.time >= begin; }),
               states.end());
  const std::vector<AgentState> driven = toStates(motion.points);
  states.insert(states.end(), driven.begin(), driven.end());
  if (motion.points.back().speed != 0.0) return track;
  for (double time = states.back().time + kFrameInterval; time < end + kFrameInterval;
       time += kFrameInterval) {
    states.push_back({std::min(time, end), states.back().pose, Vector2::Zero()});
    if (time >= end) break;
  }
  return track;
}

void addSupports(const std::vector<SupportVehicle>& supports, Snapshot& snapshot) {
  for (const SupportVehicle& support : supports) {
    const Track* recorded = findTrack(snapshot.agents, support.motion.attacker_id);
    const Track whole = trackOf(support, recorded, snapshot.now);
    Track seen{whole.id, whole.agent_class, whole.size, {}, whole.height};
    for (const AgentState& state : snapshot.ego.states) {
      if (const auto found = stateAt(whole, state.time)) seen.states.push_back(*found);
    }
    if (!seen.states.empty()) replace(snapshot.agents, std::move(seen));
  }
}

void addSupports(const std::vector<SupportVehicle>& supports, Future& future) {
  if (future.ego.states.empty()) return;
  const double begin = future.ego.states.front().time - kTimeEpsilon;
  for (const SupportVehicle& support : supports) {
    const Track* recorded = findTrack(future.agents, support.motion.attacker_id);
    Track track = trackOf(support, recorded, future.ego.states.back().time);
    auto& states = track.states;
    states.erase(states.begin(),
                 std::find_if(states.begin(), states.end(),
                              [=](const AgentState& state) { return state.time >= begin; }));
    if (!states.empty()) replace(future.agents, std::move(track));
  }
}

void addSupports(const std::vector<SupportVehicle>& supports, Scene& scene) {
  if (scene.ego.states.empty()) return;
  for (const SupportVehicle& support : supports) {
    const Track* recorded = findTrack(scene.agents, support.motion.attacker_id);
    replace(scene.agents, trackOf(support, recorded, scene.ego.states.back().time));
  }
}

}  // namespace forge
