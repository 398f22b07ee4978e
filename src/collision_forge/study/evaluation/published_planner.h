#pragma once

#include <memory>
#include <vector>

#include "collision_forge/base/scene/attack.h"
#include "collision_forge/io/collide/collide_clip.h"
#include "collision_forge/planner_test/planners/idm.h"
#include "collision_forge/planner_test/trials/planner_case.h"
#include "collision_forge/study/evaluation/options.h"

namespace forge {

// Clips of COLLIDE whose ego is driven by a planner, for publishedOutcome().

/// The clip with the ego driving as given in every frame from the first point on; frames after the
/// last point keep its pose. Throws std::invalid_argument without points.
CollideClip withEgo(CollideClip clip, const std::vector<TrajectoryPoint>& driven);

/// The clip with its attacker driving as given in the frames after now; its speed there is that
/// since the frame before.
CollideClip withAttacker(CollideClip clip, const AttackerTrajectory& trajectory);

/// One step of an ego that IDM drives.
struct PublishedIdmStep {
  Pose2 pose;
  double speed = 0.0;  ///< m/s, over the step that ends here
};

/// The ego of a clip as the planner test of arXiv 2510.12206 drives it by IDM behind the clip's
/// attacker, at every step of publishedOutcome():
///
/// 1. It starts in frame 0, at the recorded place and speed.
/// 2. Each step it takes the speed of publishedIdmSpeed() behind where the attacker is at the end
///    of the step, at the recorded speed (column V) of the frame at or before it, in the last frame
///    and after it of the frame before. Distances are those of the middles.
/// 3. It moves by that speed in the direction in which the recorded ego moves in the same step, and
///    stays where that stands still. Its heading is the recorded one, held from frame to frame.
///
/// Who is missing in a frame is not there around it, while in the original its row of zeros is a
/// place to drive to and from; it is not known to change a hit.
std::vector<PublishedIdmStep> publishedIdmDrive(const CollideClip& clip,
                                                const PublishedIdmOptions& idm,
                                                const PublishedOptions& protocol);

/// publishedOutcome() on `clip`, whose attacker drives as in the case.
std::shared_ptr<const PublishedProtocol> publishedProtocol(CollideClip clip,
                                                           const PublishedOptions& options);

}  // namespace forge
