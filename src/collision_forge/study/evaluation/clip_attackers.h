#pragma once

#include <vector>

#include "collision_forge/attack/search/options.h"
#include "collision_forge/base/scene/attack.h"
#include "collision_forge/base/scene/scene.h"
#include "collision_forge/io/collide/collide_clip.h"
#include "collision_forge/study/evaluation/options.h"

namespace forge {

/// Returns the request that a clip represents: its type, its attacker, and as TTA the time from t0
/// to the last frame, raised to `min_tta` (s) if it is less, because frames may be slightly less
/// than 0.5 s apart. `crash` defines the conditions of success. All other fields have their
/// defaults.
CollisionRequest requestOf(const CollideClip& clip, Mode mode, double min_tta,
                           CrashDefinition crash);

// Trajectories of attackers that need no search: from t0 to `search.tail` s after the last frame of
// the clip, both included, with points evenly spaced by about `search.step` s, of class car,
// without a past. `box` is the attacker's size.

/// Returns the trajectory of the data set's attacker, box centres in the map frame. Positions,
/// speed, acceleration and curvature come from the quintic through the six frames around each
/// instant, which is exact for COLLIDE, whose tracks are quintics; headings are interpolated.
/// Continues straight after the last frame.
AttackerTrajectory recordedAttacker(const CollideClip& clip, const BoxSize& box,
                                    const SearchOptions& search);

/// Returns the trajectory of an attacker that keeps the speed (column V) and heading that it has at
/// t0.
AttackerTrajectory constantVelocityAttacker(const CollideClip& clip, const BoxSize& box,
                                            const SearchOptions& search);

/// Returns the attacker's pose (map frame) in each frame of the clip: recorded up to t0, then on
/// `trajectory` at the time of the frame (clamped to its ends).
std::vector<Pose2> framesOf(const CollideClip& clip, const AttackerTrajectory& trajectory);

/// Returns the recorded pose (map frame) of the attacker in each frame of the clip.
std::vector<Pose2> recordedFrames(const CollideClip& clip);

}  // namespace forge
