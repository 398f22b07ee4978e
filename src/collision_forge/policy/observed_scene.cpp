#include "collision_forge/policy/observed_scene.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

namespace forge {
namespace {

constexpr double kTimeEpsilon = 1e-6;  // s, the resolution of the clock

/// The agents of a snapshot that have a state at `time`, with that state alone.
std::vector<Track> agentsAt(const Snapshot& snapshot, double time) {
  std::vector<Track> agents;
  for (const Track& agent : snapshot.agents) {
    const auto state = std::find_if(
        agent.states.begin(), agent.states.end(),
        [=](const AgentState& seen) { return std::abs(seen.time - time) < kTimeEpsilon; });
    if (state == agent.states.end()) continue;
    agents.push_back({agent.id, agent.agent_class, agent.size, {*state}});
  }
  return agents;
}

}  // namespace

ObservedScene::ObservedScene(const Snapshot& start, const EgoVehicle& ego, int frames,
                             double interval)
    : map_(start.map), ego_(ego), count_(frames), interval_(interval) {
  for (const AgentState& state : start.ego.states) {
    frames_.push_back({state.time, state.pose, agentsAt(start, state.time)});
  }
}

void ObservedScene::add(const Frame& frame) {
  frames_.push_back(frame);
  const double oldest = frame.time - interval_ * (count_ + 1);
  while (frames_.front().time < oldest) frames_.pop_front();
}

Snapshot ObservedScene::snapshot() const {
  std::vector<const Frame*> shown = {&frames_.back()};  // newest first
  auto next = std::next(frames_.rbegin());
  while (next != frames_.rend() && static_cast<int>(shown.size()) < count_) {
    const auto offInterval = [&](const Frame& frame) {
      return std::abs(shown.back()->time - frame.time - interval_);
    };
    const auto best = std::min_element(next, frames_.rend(), [&](const Frame& a, const Frame& b) {
      return offInterval(a) < offInterval(b);
    });
    shown.push_back(&*best);
    next = std::next(best);
  }
  SceneHistory history(count_, ego_);
  for (auto frame = shown.rbegin(); frame != shown.rend(); ++frame) history.add(**frame);
  Snapshot snapshot = history.snapshot();
  snapshot.map = map_;
  return snapshot;
}

}  // namespace forge
