#pragma once

#include <cstdint>
#include <string>

namespace forge {

// The wave of acceleration of a driver that keeps its speed; chosen as kDrivingStyles.
inline constexpr double kMaxVariation = 1.0;    ///< m/s2
inline constexpr double kShortestPeriod = 4.0;  ///< s
inline constexpr double kLongestPeriod = 8.0;   ///< s

/// How a driver's speed wanders, though it wants to drive evenly: nobody holds a pedal still. One
/// wave of acceleration, a(t) = amplitude sin(2 pi t / period + phase), t from now.
struct SpeedVariation {
  double amplitude = 0.0;  ///< m/s2
  double period = 1.0;     ///< s
  double phase = 0.0;      ///< rad

  double frequency() const;  ///< rad/s
  /// Metres that the driver is ahead, at a time in s from now, of one who drives evenly, as fast
  /// now.
  double way(double time) const;
};

/// A vehicle's, by its id and the request's seed: the same for the same.
SpeedVariation variationOf(const std::string& id, std::uint64_t seed);

}  // namespace forge
