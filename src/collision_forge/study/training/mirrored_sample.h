#pragma once

#include "collision_forge/study/training/training_sample.h"

namespace forge {

// Return the argument mirrored at the ego's x axis: left and right are exchanged. Applying them
// twice returns the original.

SceneFeatures mirrored(SceneFeatures features);
TimedSample mirrored(TimedSample sample);
/// Keeps the collision type, so `attack` must not be a left turn (ltap).
AttackSample mirrored(AttackSample attack);
Pose2 mirrored(const Pose2& pose);

}  // namespace forge
