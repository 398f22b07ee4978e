#pragma once

#include <cstdint>
#include <string>

namespace forge {

/// Returns true if two times, us, differ by at most 1 us, as rounded stamps of one instant do.
inline bool isSameInstant(std::int64_t a_us, std::int64_t b_us) {
  const std::int64_t apart = a_us - b_us;
  return apart >= -1 && apart <= 1;
}

/// m; poses of the ego at one instant that are further apart contradict each other.
inline constexpr double kSamePlace = 0.5;

/// Returns the message for a bag with two such poses; `distance` in m.
inline std::string contradiction(double distance, std::int64_t time_us) {
  constexpr double kSeconds = 1e-6;  // in a microsecond
  return "two poses of the ego at " + std::to_string(static_cast<double>(time_us) * kSeconds) +
         " s are " + std::to_string(distance) + " m apart";
}

}  // namespace forge
