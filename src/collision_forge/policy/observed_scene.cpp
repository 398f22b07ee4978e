#include "collision_forge/policy/observed_scene.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

namespace forge {
ObservedScene::ObservedScene(const Snapshot& start, const EgoVehicle& ego, int frames,
                             double interval)
    : map_(start.map), ego_(ego), count_(frames), interval_(interval) {
  for (const AgentState& state : start.ego.states) {
    frames_.push_back({state.time, state.pose, agentsAt(start.agents, state.time)});
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
