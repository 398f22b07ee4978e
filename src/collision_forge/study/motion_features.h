#pragma once

#include <vector>

#include "collision_forge/study/motion_distances.h"
#include "collision_forge/study/two_sample_classifier.h"

namespace forge {

/// What a classifier may know of a window's motion: speeds, accelerations, jerk, turning and
/// steering, as means and extremes. Nothing of place, time, class or size, nor of how well the fit
/// meets the samples; left is as good as right. Steering counts 0 where there is none. Rounded to
/// steps of about the noise: annotators repeat a yaw exactly, by which alone a classifier tells
/// them from motion that is computed.
std::vector<double> motionFeatures(const WindowMotion& motion);

/// One row a window.
FeatureTable featuresOf(const std::vector<DescribedMotion>& motions);

}  // namespace forge
