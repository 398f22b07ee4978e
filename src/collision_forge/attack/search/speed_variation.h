#pragma once

#include <cstdint>
#include <string>

#include "collision_forge/attack/search/options.h"

namespace forge {

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
SpeedVariation variationOf(const std::string& id, std::uint64_t seed,
                           const RouteDriverOptions& options);

}  // namespace forge
