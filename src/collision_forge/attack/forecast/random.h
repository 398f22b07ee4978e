#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>

namespace forge {

/// Random numbers that are identical on all platforms: std::mt19937_64 is standardised, the
/// standard library's distributions are not. Not thread-safe.
class Random {
 public:
  explicit Random(std::uint64_t seed) : generator_(seed) {}

  /// Returns a uniform number in [low, high); `low` if both are equal.
  double uniform(double low, double high) {
    return low + static_cast<double>(generator_() >> 11) * 0x1p-53 * (high - low);
  }

  /// Returns a zero-mean bell-shaped number with standard deviation `deviation`, within 3.46
  /// deviations: the scaled sum of four uniform numbers (Irwin-Hall), taken from one 64-bit draw.
  double bell(double deviation) {
    const std::uint64_t draw = generator_();
    const std::uint64_t sum =
        (draw & 0xFFFF) + (draw >> 16 & 0xFFFF) + (draw >> 32 & 0xFFFF) + (draw >> 48);
    return (static_cast<double>(sum) * 0x1p-16 - kMiddle) * kScale * deviation;
  }

  /// Returns a uniform index in [0, count). `count` must be positive.
  std::size_t index(std::size_t count) {
    return std::min(count - 1, static_cast<std::size_t>(uniform(0.0, static_cast<double>(count))));
  }

 private:
  static constexpr double kMiddle = 2.0 - 0x1p-15;      // mean of the sum
  static constexpr double kScale = 1.7320508075688772;  // sqrt(3), one over the sum's deviation

  std::mt19937_64 generator_;
};

}  // namespace forge
