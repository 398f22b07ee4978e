#include "collision_forge/trials/published_planner.h"

#include <stdexcept>

namespace forge {
namespace {

Track trackOf(const CollideClip& clip, const CollideTrack& recorded) {
  Track track{recorded.id, AgentClass::kCar, {}, {}};
  for (std::size_t frame = 0; frame < clip.times.size(); ++frame) {
    const auto& state = recorded.frames[frame];
    if (state) track.states.push_back({clip.times[frame], state->pose, Vector2::Zero()});
  }
  return track;
}

/// With the velocity over the interval that `time` lies in; the last interval's at its end.
AgentState movingAt(const Track& track, double time) {
  std::size_t next = 1;
  while (next + 1 < track.states.size() && track.states[next].time <= time) ++next;
  const AgentState& before = track.states[next - 1];
  const AgentState& after = track.states[next];
  AgentState state = stateAt(track, time, after.time - before.time).value_or(track.states.back());
  state.velocity = (after.pose.position() - before.pose.position()) / (after.time - before.time);
  return state;
}

std::vector<Vector2> wayOf(const Track& ego, double length_ahead) {
  std::vector<Vector2> way;
  for (const AgentState& state : ego.states) way.push_back(state.pose.position());
  const Pose2& last = ego.states.back().pose;
  way.push_back(last.position() + length_ahead * last.heading());
  return way;
}

}  // namespace

CollideClip withEgo(CollideClip clip, const std::vector<TrajectoryPoint>& driven) {
  if (driven.empty()) throw std::invalid_argument("the ego of " + clip.name + " has no motion");
  Track ego{kEgoId, AgentClass::kCar, {}, {}};
  for (const TrajectoryPoint& point : driven) {
    ego.states.push_back({point.time, point.pose, point.speed * point.pose.heading()});
  }
  for (CollideTrack& track : clip.tracks) {
    if (track.id != kEgoId) continue;
    for (std::size_t frame = 0; frame < track.frames.size(); ++frame) {
      if (clip.times[frame] < ego.states.front().time) continue;
      const AgentState state = stateAt(ego, clip.times[frame]).value_or(ego.states.back());
      track.frames[frame] = CollideState{state.pose, state.velocity.norm()};
    }
  }
  return clip;
}

CollideClip withPublishedIdm(const CollideClip& clip, const PublishedIdmOptions& options,
                             double length_ahead) {
  const Track ego = trackOf(clip, clip.ego());
  const Track attacker = trackOf(clip, clip.attacker());
  PublishedIdmPlanner planner(options, clip.attacker_id);
  planner.initialize({nullptr, wayOf(ego, length_ahead), {}, 0.0});
  const AgentState start = movingAt(ego, clip.times.front());
  std::vector<TrajectoryPoint> driven = {{start.time, start.pose, start.velocity.norm(), 0.0, 0.0}};
  while (driven.back().time < clip.times.back()) {
    const double time = driven.back().time;
    const Track seen{attacker.id, attacker.agent_class, attacker.size, {movingAt(attacker, time)}};
    driven.push_back(planner.plan({driven.back(), {seen}}).back());
  }
  return withEgo(clip, driven);
}

}  // namespace forge
