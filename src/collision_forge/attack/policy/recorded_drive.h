#pragma once

#include "collision_forge/attack/policy/attacker_policy.h"
#include "collision_forge/base/scene/scene.h"

namespace forge {

/// The frame of a recording at `time`, everybody with one state; the ego's pose is not finite where
/// it was not recorded.
Frame frameAt(const Scene& scene, double time);

/// Shows a policy the frames of a recording after `now`, one by one, up to the end of its
/// trajectory: the ego drives as recorded, whatever the attacker does. Milliseconds of the wall
/// clock that each look took.
std::vector<double> driveOverRecording(AttackerPolicy& policy, const Scene& scene, double now);

}  // namespace forge
