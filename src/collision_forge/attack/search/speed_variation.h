#pragma once

#include <cstdint>
#include <string>

namespace forge {

// Ranges from which variationOf() draws. Chosen so that a classifier can hardly separate attackers
// from recorded vehicles.
inline constexpr double kMaxVariation = 1.0;    ///< m/s2, largest amplitude
inline constexpr double kShortestPeriod = 4.0;  ///< s, shortest period
inline constexpr double kLongestPeriod = 8.0;   ///< s, longest period

/// Small variation of a driver's speed around constant driving: one wave of acceleration, a(t) =
/// amplitude sin(2 pi t / period + phase), t in s after t0.
struct SpeedVariation {
  double amplitude = 0.0;  ///< m/s2
  double period = 1.0;     ///< s
  double phase = 0.0;      ///< rad

  /// Returns 2 pi / period, rad/s.
  double frequency() const;
  /// Returns the distance (m, may be negative) gained by `time` (s after t0; negative: before) over
  /// a driver without variation and with the same speed at t0.
  double distanceGained(double time) const;
};

/// Returns the variation of the vehicle `id`: a uniform pseudorandom draw from the ranges above
/// (any phase) that depends only on `id` and `seed`, the request's, on all platforms.
SpeedVariation variationOf(const std::string& id, std::uint64_t seed);

}  // namespace forge
