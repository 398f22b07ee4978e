#include "collision_forge/base/scene/scene.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "collision_forge/base/scene/clock.h"

namespace forge {
namespace {

Track between(const Track& track, double first, double last) {
  Track part{track.id, track.agent_class, track.size, {}, track.height};
  std::copy_if(track.states.begin(), track.states.end(), std::back_inserter(part.states),
               [=](const AgentState& state) {
                 return state.time >= first - kTimeEpsilon && state.time <= last + kTimeEpsilon;
               });
  return part;
}

/// Returns the track's states at `times` (ascending) at which it has one.
Track statesAt(const Track& track, const std::vector<double>& times) {
  Track part{track.id, track.agent_class, track.size, {}, track.height};
  auto time = times.begin();
  for (const AgentState& state : track.states) {
    while (time != times.end() && *time < state.time - kTimeEpsilon) ++time;
    if (time == times.end()) break;
    if (*time <= state.time + kTimeEpsilon) part.states.push_back(state);
  }
  return part;
}

}  // namespace

std::optional<double> lastFrameTime(const Scene& scene, double time) {
  const auto after =
      std::upper_bound(scene.frame_times.begin(), scene.frame_times.end(), time + kTimeEpsilon);
  if (after == scene.frame_times.begin()) return std::nullopt;
  return *std::prev(after);
}

std::vector<double> historyTimes(const std::vector<double>& times, int count) {
  std::vector<double> found;
  auto end = times.end();
  while (end != times.begin() && static_cast<int>(found.size()) < count) {
    const auto offInterval = [&](double time) {
      return std::abs(found.back() - time - kFrameInterval);
    };
    const auto last = std::prev(end);
    const auto best =
        found.empty() ? last : std::min_element(times.begin(), end, [&](double a, double b) {
          return offInterval(a) < offInterval(b);
        });
    found.push_back(*best);
    end = best;
  }
  std::reverse(found.begin(), found.end());
  return found;
}

Snapshot snapshotAt(const Scene& scene, double now, int frames) {
  const auto end =
      std::upper_bound(scene.frame_times.begin(), scene.frame_times.end(), now + kTimeEpsilon);
  const std::vector<double> times = historyTimes({scene.frame_times.begin(), end}, frames);

  Snapshot snapshot;
  snapshot.now = now;
  snapshot.map = scene.map;
  snapshot.ego = Track{scene.ego.id, scene.ego.agent_class, scene.ego.size, {}};
  if (times.empty()) return snapshot;
  for (const double time : times) {
    if (const auto state = stateAt(scene.ego, time)) snapshot.ego.states.push_back(*state);
  }
  deriveVelocities(snapshot.ego);
  for (const Track& agent : scene.agents) {
    Track seen = statesAt(agent, times);
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
