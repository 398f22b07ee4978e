#pragma once

#include "collision_forge/study/training/training_sample.h"

namespace forge {

// Return the argument mirrored at the x axis of the frame in which it is given, the ego's at t0:
// left and right are exchanged. Applying them twice returns the original.

/// Mirrors the scaled features of agents, lanes and ego; keeps the masks.
SceneFeatures mirrored(SceneFeatures features);
/// Mirrors the ego pose and its anchors; the order of the anchors stays.
TimedSample mirrored(TimedSample sample);
/// Mirrors the poses of ego and candidates, and the offset in the frame of the ego at impact. Keeps
/// the collision type, so `attack` must not be a left turn (ltap).
AttackSample mirrored(AttackSample attack);
/// Returns {x, -y, -yaw}.
Pose2 mirrored(const Pose2& pose);

}  // namespace forge
