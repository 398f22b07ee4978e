#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "collision_forge/io/collide/collide_clip.h"

namespace forge {

inline constexpr double kClipStart = 1533153458.396528;  // s, of frame 0; t0 is 3.5 s later

/// Frames 0 to `last_frame` at 2 Hz at constant velocity through `now` in frame 7.
inline CollideTrack straightClipTrack(const std::string& id, const Pose2& now, double speed,
                                      int last_frame) {
  CollideTrack track{id, {}};
  for (int frame = 0; frame <= last_frame; ++frame) {
    const double elapsed = 0.5 * (frame - kCollideNowFrame);
    track.frames.push_back(CollideState{compose(now, {speed * elapsed, 0.0, 0.0}), speed});
  }
  return track;
}

/// The ego is at the origin heading along x at t0; ego and attacker move at constant velocity.
inline CollideClip straightClip(CollisionType type, double angle_degrees, int last_frame,
                                double ego_speed, const Pose2& attacker_now,
                                double attacker_speed) {
  CollideClip clip;
  clip.batch = "v4.5";
  clip.city = "embedded-right";
  clip.scene = "scene-0001";
  clip.type = type;
  clip.placement = 4;
  clip.variant = 3;
  clip.collision_frame = last_frame;
  clip.angle = angle_degrees * M_PI / 180.0;
  clip.attacker_id = "attacker";
  clip.name = composeCollideName(clip);
  clip.name.resize(clip.name.size() - 4);  // without ".csv"
  for (int frame = 0; frame <= last_frame; ++frame) {
    clip.times.push_back(kClipStart + 0.5 * frame);
  }
  clip.tracks = {straightClipTrack("attacker", attacker_now, attacker_speed, last_frame),
                 straightClipTrack("ego", {}, ego_speed, last_frame)};
  return clip;
}

/// A vehicle at rest at `pose`.
inline CollideTrack standingClipTrack(const std::string& id, const Pose2& pose, int last_frame) {
  return straightClipTrack(id, pose, 0.0, last_frame);
}

}  // namespace forge
