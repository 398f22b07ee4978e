#pragma once

#include <memory>
#include <vector>

#include "collision_forge/base/scene/attack.h"
#include "collision_forge/io/collide/collide_clip.h"
#include "collision_forge/planner_test/planners/idm.h"
#include "collision_forge/planner_test/trials/planner_case.h"
#include "collision_forge/study/evaluation/options.h"

namespace forge {

// COLLIDE clips with an ego driven by a planner, for publishedOutcome().

/// Returns the clip with the ego's frames replaced by `driven` (box centres, map frame, clip's
/// clock), interpolated (stateAt()), from the time of its first point on. Frames after the last
/// point, and between points more than kMaxGap apart, have the pose and speed of the last point.
/// Throws std::invalid_argument for an empty `driven`.
CollideClip withEgo(CollideClip clip, const std::vector<TrajectoryPoint>& driven);

/// Returns the clip with the attacker's frames after t0 replaced by poses of `trajectory`
/// (poseAt(), clamped to its ends); speeds are mean speeds since the previous frame.
CollideClip withAttacker(CollideClip clip, const AttackerTrajectory& trajectory);

/// One step of an ego driven by IDM (Intelligent Driver Model).
struct PublishedIdmStep {
  Pose2 pose;          ///< at the end of the step, map frame
  double speed = 0.0;  ///< m/s, over the step
};

/// Simulates the ego of the planner test of arXiv 2510.12206: IDM that follows the clip's attacker.
/// Returns its state at each step of publishedSteps(), the first being its recorded one.
///
/// 1. The ego starts in frame 0 with its recorded pose and speed.
/// 2. In each step its speed is publishedIdmSpeed() with the attacker as lead: the distance between
///    the centres, with the attacker's position at the end of the step, and the attacker's recorded
///    speed (column V) in the last frame before, from the last frame on in the frame before the
///    last.
/// 3. It moves with that speed for `idm.step` s in the direction of the recorded ego in the same
///    step, and stays if the recorded ego stands still. Its heading is the recorded one, held
///    between frames.
///
/// Deviation from the original: an agent that is missing in a frame is absent, while the original
/// uses a row of zeros as its position. No hit is known to depend on it.
std::vector<PublishedIdmStep> publishedIdmDrive(const CollideClip& clip,
                                                const PublishedIdmOptions& idm,
                                                const PublishedOptions& protocol);

/// Returns the protocol that applies publishedOutcome() to `clip` with a given motion of the ego
/// (withEgo()), or with the ego of publishedIdmDrive(). The attacker moves as in `clip`.
std::shared_ptr<const PublishedProtocol> publishedProtocol(CollideClip clip,
                                                           const PublishedOptions& options);

}  // namespace forge
