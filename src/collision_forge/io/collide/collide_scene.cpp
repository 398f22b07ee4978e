#include "collision_forge/io/collide/collide_scene.h"

#include <cmath>

namespace forge {
namespace {

AgentState stateOf(const CollideState& state, double time) {
  return {time, state.pose, state.speed * state.pose.heading()};
}

/// Returns the velocity at the last frame; the track must be in it.
Vector2 lastVelocity(const CollideTrack& track, const std::vector<double>& times) {
  const std::size_t last = times.size() - 1;
  const CollideState& state = *track.frames[last];
  const auto& before = track.frames[last - 1];
  if (!before) return state.speed * state.pose.heading();
  return (state.pose.position() - before->pose.position()) / (times[last] - times[last - 1]);
}

void goStraightOn(Track& track, const Vector2& velocity, double duration) {
  const AgentState last = track.states.back();
  const int steps = static_cast<int>(std::ceil(duration / kCollideFrameInterval));
  for (int step = 1; step <= steps; ++step) {
    const double elapsed = duration * step / steps;
    const Vector2 position = last.pose.position() + elapsed * velocity;
    track.states.push_back(
        {last.time + elapsed, {position.x(), position.y(), last.pose.yaw}, velocity});
  }
}

/// Returns the frames from `first` on in which the track is present, then constant velocity.
Track recordedTrack(const CollideTrack& recorded, const CollideClip& clip, std::size_t first,
                    const CollideOptions& options) {
  Track track{recorded.id, AgentClass::kCar, options.box, {}};
  for (std::size_t frame = first; frame < clip.times.size(); ++frame) {
    const auto& state = recorded.frames[frame];
    if (state) track.states.push_back(stateOf(*state, clip.times[frame]));
  }
  if (recorded.frames.back()) {
    goStraightOn(track, lastVelocity(recorded, clip.times), options.tail);
  }
  return track;
}

/// Returns the attacker's state one frame before t0, extrapolated backwards at constant velocity.
AgentState straightBefore(const CollideClip& clip) {
  const CollideState& now = *clip.attacker().frames[kCollideNowFrame];
  const double frame_before = clip.times[kCollideNowFrame - 1];
  CollideState before = now;
  before.pose = compose(now.pose, {(frame_before - clip.now()) * now.speed, 0.0, 0.0});
  return stateOf(before, frame_before);
}

}  // namespace

Scene toScene(const CollideClip& clip, const CollideOptions& options,
              std::shared_ptr<const LaneMap> map) {
  Scene scene;
  scene.name = clip.name;
  scene.map = std::move(map);
  scene.frame_times = clip.times;
  for (const CollideTrack& recorded : clip.tracks) {
    const bool is_attacker = recorded.id == clip.attacker_id;
    Track track = recordedTrack(recorded, clip, is_attacker ? kCollideNowFrame : 0, options);
    if (track.states.empty()) continue;
    if (is_attacker) track.states.insert(track.states.begin(), straightBefore(clip));
    deriveVelocities(track);
    if (recorded.id == kEgoId) {
      scene.ego = std::move(track);
    } else {
      scene.agents.push_back(std::move(track));
    }
  }
  return scene;
}

}  // namespace forge
