#include "collision_forge/scene/scene.h"

#include <algorithm>

namespace forge {
namespace {

// Annotation frames and states come from the same clock; this only absorbs rounding.
constexpr double kTimeEpsilon = 1e-6;

Track between(const Track& track, double first, double last) {
  Track part{track.id, track.agent_class, track.size, {}};
  std::copy_if(track.states.begin(), track.states.end(), std::back_inserter(part.states),
               [=](const AgentState& state) {
                 return state.time >= first - kTimeEpsilon && state.time <= last + kTimeEpsilon;
               });
  return part;
}

}  // namespace

std::optional<double> lastFrameTime(const Scene& scene, double time) {
  const auto after =
      std::upper_bound(scene.frame_times.begin(), scene.frame_times.end(), time + kTimeEpsilon);
  if (after == scene.frame_times.begin()) return std::nullopt;
  return *std::prev(after);
}

Snapshot snapshotAt(const Scene& scene, double now, int frames) {
  const auto end =
      std::upper_bound(scene.frame_times.begin(), scene.frame_times.end(), now + kTimeEpsilon);
  const auto available = static_cast<int>(std::distance(scene.frame_times.begin(), end));
  const auto begin = end - std::min(available, frames);

  Snapshot snapshot;
  snapshot.now = now;
  snapshot.map = scene.map;
  snapshot.ego = Track{scene.ego.id, scene.ego.agent_class, scene.ego.size, {}};
  if (begin == end) return snapshot;
  for (auto frame = begin; frame != end; ++frame) {
    if (const auto state = stateAt(scene.ego, *frame)) snapshot.ego.states.push_back(*state);
  }
  deriveVelocities(snapshot.ego);
  for (const Track& agent : scene.agents) {
    Track seen = between(agent, *begin, now);
    if (seen.states.empty()) continue;
    deriveVelocities(seen);
    snapshot.agents.push_back(std::move(seen));
  }
  return snapshot;
}

Future recordedFuture(const Scene& scene, double now) {
  const double end = scene.ego.states.empty() ? now : scene.ego.states.back().time;
  Future future;
  future.ego = between(scene.ego, now, end);
  for (const Track& agent : scene.agents) {
    Track rest = between(agent, now, end);
    if (!rest.states.empty()) future.agents.push_back(std::move(rest));
  }
  return future;
}

}  // namespace forge
