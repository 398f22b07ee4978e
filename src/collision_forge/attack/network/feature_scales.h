#pragma once

#include <algorithm>

namespace forge {

// What features are divided by to be of order one.
inline constexpr double kPlaceScale = 30.0;        // m
inline constexpr double kSpeedScale = 10.0;        // m/s
inline constexpr double kAccelerationScale = 2.0;  // m/s2
inline constexpr double kTurnRateScale = 0.2;      // rad/s
inline constexpr double kMaxFeature = 4.0;         // times these at most

inline double held(double value, double limit) { return std::clamp(value, -limit, limit); }

}  // namespace forge
