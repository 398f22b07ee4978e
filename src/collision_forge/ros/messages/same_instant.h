#pragma once

#include <cstdint>
#include <string>

namespace forge {

/// Returns true if two times in us (of one clock) differ by at most 1 us, the rounding error of
/// stamps.
inline bool isSameInstant(std::int64_t a_us, std::int64_t b_us) {
  const std::int64_t apart = a_us - b_us;
  return apart >= -1 && apart <= 1;
}

/// m; two poses of the ego at the same time contradict each other if they are farther apart.
inline constexpr double kSamePlace = 0.5;

/// Returns the error text for two poses of the ego that contradict each other. `distance`: m
/// between them; `time_us`: their time, us.
inline std::string contradiction(double distance, std::int64_t time_us) {
  constexpr double kSeconds = 1e-6;  // in a microsecond
  return "two poses of the ego at " + std::to_string(static_cast<double>(time_us) * kSeconds) +
         " s are " + std::to_string(distance) + " m apart";
}

}  // namespace forge
