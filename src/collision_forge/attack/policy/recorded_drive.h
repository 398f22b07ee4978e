#pragma once

#include "collision_forge/attack/policy/attacker_policy.h"
#include "collision_forge/base/scene/scene.h"

namespace forge {

/// Returns the frame of a recording at `time` (s), each agent with one state. The ego's pose is not
/// finite if it was not recorded then.
Frame frameAt(const Scene& scene, double time);

/// Calls policy.observe() with each frame of the recording after `now` (s) up to the end of the
/// policy's trajectory; the ego drives as recorded and does not react. Returns the wall-clock time
/// of each update step in milliseconds.
std::vector<double> driveOverRecording(AttackerPolicy& policy, const Scene& scene, double now);

}  // namespace forge
