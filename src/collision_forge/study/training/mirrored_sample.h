#pragma once

#include "collision_forge/study/training/training_sample.h"

namespace forge {

// The world in a mirror along the ego's x axis: left becomes right. Mirrored twice is the same.

SceneFeatures mirrored(SceneFeatures features);
TimedSample mirrored(TimedSample sample);
/// The type stays: do not mirror left turns.
AttackSample mirrored(AttackSample attack);
Pose2 mirrored(const Pose2& pose);

}  // namespace forge
