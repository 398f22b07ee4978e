#pragma once

#include <vector>

#include "collision_forge/attack/search/options.h"
#include "collision_forge/base/scene/attack.h"
#include "collision_forge/base/scene/scene.h"
#include "collision_forge/io/collide/collide_clip.h"
#include "collision_forge/study/evaluation/options.h"

namespace forge {

/// The clip as a request: its type, its attacker, its time from now to the last frame (at least
/// `min_tta`, which frames a little less than half a second apart fall short of). `crash` is what
/// counts.
CollisionRequest requestOf(const CollideClip& clip, Mode mode, double min_tta,
                           CrashDefinition crash);

// What attackers without a search drive, from now to `search.tail` seconds after the last frame of
// the clip or the time asked for, a point every `search.step` seconds. A clip's `snapshot` and
// `recorded` are those of io/collide/collide_scene.h.

/// The set's own attacker. Speed, acceleration and curvature are those of the quintic through the
/// six frames around each instant, which are exact where the track is one quintic, as the set's
/// are; headings are the recorded ones, interpolated. After the last frame straight on.
AttackerTrajectory recordedAttacker(const CollideClip& clip, const BoxSize& box,
                                    const SearchOptions& search);

/// The attacker keeps its speed and heading of now.
AttackerTrajectory constantVelocityAttacker(const CollideClip& clip, const BoxSize& box,
                                            const SearchOptions& search);

/// The attacker's pose in every frame of the clip: up to now as recorded, then of the trajectory.
std::vector<Pose2> framesOf(const CollideClip& clip, const AttackerTrajectory& trajectory);

/// As recorded in every frame.
std::vector<Pose2> recordedFrames(const CollideClip& clip);

}  // namespace forge
