#pragma once

#include <algorithm>

namespace forge {

// Units of the features of sceneFeatures(), anchorFeatures() and candidateFeatures(): values are
// divided by these to be of order one.
inline constexpr double kPlaceScale = 30.0;        // m
inline constexpr double kSpeedScale = 10.0;        // m/s
inline constexpr double kAccelerationScale = 2.0;  // m/s2
inline constexpr double kTurnRateScale = 0.2;      // rad/s
inline constexpr double kMaxFeature = 4.0;         // largest |scaled feature|

/// Returns `value` clamped to [-limit, limit].
inline double clampedTo(double value, double limit) { return std::clamp(value, -limit, limit); }

}  // namespace forge
