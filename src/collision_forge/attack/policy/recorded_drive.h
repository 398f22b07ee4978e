#pragma once

#include "collision_forge/attack/policy/attacker_policy.h"
#include "collision_forge/base/scene/scene.h"

namespace forge {

/// Returns the frame of a recording at `time` (s, scene clock): the agents with a state at that
/// time (to 1 us), each with this state alone, and the ego's pose, interpolated. The ego's pose is
/// NaN if it was not recorded then: outside its track, or in a gap longer than kMaxGap.
Frame frameAt(const Scene& scene, double time);

/// Calls policy.observe() with each frame (Scene::frame_times) of the recording after `now` (s,
/// scene clock) and before the end of the policy's trajectory; the ego drives as recorded and does
/// not react. Returns the wall-clock time of each call in milliseconds, in order.
std::vector<double> driveOverRecording(AttackerPolicy& policy, const Scene& scene, double now);

}  // namespace forge
