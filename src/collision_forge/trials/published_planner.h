#pragma once

#include <vector>

#include "collision_forge/data/collide_clip.h"
#include "collision_forge/planners/idm.h"
#include "collision_forge/scene/attack.h"

namespace forge {

// Clips of COLLIDE whose ego is driven by a planner, for publishedOutcome().

/// The clip with the ego driving as given in every frame from the first point on; frames after the
/// last point keep its pose. Throws std::invalid_argument without points.
CollideClip withEgo(CollideClip clip, const std::vector<TrajectoryPoint>& driven);

/// The clip with the ego driven by PublishedIdmPlanner behind the set's attacker, as the published
/// figures were measured: from frame 0 on, history included, along its recorded path and straight
/// on for `length_ahead` metres after it, starting at the speed of the first interval. Positions
/// are linear between frames.
CollideClip withPublishedIdm(const CollideClip& clip, const PublishedIdmOptions& options,
                             double length_ahead);

}  // namespace forge
