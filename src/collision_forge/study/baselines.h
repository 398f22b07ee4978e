#pragma once

#include <vector>

#include "collision_forge/attack/options.h"
#include "collision_forge/data/collide_clip.h"
#include "collision_forge/scene/attack.h"
#include "collision_forge/scene/scene.h"
#include "collision_forge/study/options.h"

namespace forge {

/// The clip as a request: its type, its attacker, its time from now to the last frame (at least
/// `min_tta`, which frames a little less than half a second apart fall short of).
CollisionRequest requestOf(const CollideClip& clip, Mode mode, double min_tta);

// What attackers without a search drive, from now to `search.tail` seconds after the last frame of
// the clip or the time asked for, a point every `search.step` seconds. A clip's `snapshot` and
// `recorded` are those of formats/collide_scene.h.

/// The set's own attacker. Speed, acceleration and curvature are those of the quintic through the
/// six frames around each instant, which are exact where the track is one quintic, as the set's
/// are; headings are the recorded ones, interpolated. After the last frame straight on.
AttackerTrajectory recordedAttacker(const CollideClip& clip, const BoxSize& box,
                                    const SearchOptions& search);

/// The attacker keeps its speed and heading of now.
AttackerTrajectory constantVelocityAttacker(const CollideClip& clip, const BoxSize& box,
                                            const SearchOptions& search);

/// The same of an agent of any snapshot, whose motion now is that of estimateMotion().
AttackerTrajectory constantVelocityAttacker(const std::string& attacker_id,
                                            const Snapshot& snapshot, double tta,
                                            const AttackOptions& options);

/// One quintic on each axis to where the set puts attackers of the type, as seen from the ego at
/// the time asked for, which in history mode keeps its velocity and in replay mode is as recorded.
/// It comes from the side on which it is now (as seen from there), arrives with the speed it has
/// now, and no limit of a vehicle is looked at. Throws std::invalid_argument for an agent that is
/// not in the snapshot, and in replay mode for a recording that ends before.
AttackerTrajectory nominalAttacker(const std::string& attacker_id, const Snapshot& snapshot,
                                   const Future& recorded, const CollisionRequest& request,
                                   const NominalOptions& nominal, const AttackOptions& options);

/// The same to where a pattern puts its attacker, as in the paper (arXiv 2510.12206, Sec. 3.4):
/// whatever came, and whatever a vehicle can do.
AttackerTrajectory patternAttacker(const CollisionPattern& pattern, const Snapshot& snapshot,
                                   double tta, const AttackOptions& options);

/// The attacker's pose in every frame of the clip: up to now as recorded, then of the trajectory.
std::vector<Pose2> framesOf(const CollideClip& clip, const AttackerTrajectory& trajectory);

/// As recorded in every frame.
std::vector<Pose2> recordedFrames(const CollideClip& clip);

}  // namespace forge
