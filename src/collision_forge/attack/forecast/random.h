#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>

namespace forge {

/// Draws that are the same everywhere: the standard's distributions differ between libraries, its
/// generator does not.
class Random {
 public:
  explicit Random(std::uint64_t seed) : generator_(seed) {}

  double uniform(double low, double high) {
    return low + static_cast<double>(generator_() >> 11) * 0x1p-53 * (high - low);
  }

  /// Sum of four uniforms (Irwin-Hall), scaled: bell-shaped, at most 3.46 deviations wide. They are
  /// the quarters of one draw.
  double bell(double deviation) {
    const std::uint64_t draw = generator_();
    const std::uint64_t sum =
        (draw & 0xFFFF) + (draw >> 16 & 0xFFFF) + (draw >> 32 & 0xFFFF) + (draw >> 48);
    return (static_cast<double>(sum) * 0x1p-16 - kMiddle) * kScale * deviation;
  }

  /// In [0, count).
  std::size_t index(std::size_t count) {
    return std::min(count - 1, static_cast<std::size_t>(uniform(0.0, static_cast<double>(count))));
  }

 private:
  static constexpr double kMiddle = 2.0 - 0x1p-15;      // the mean of the sum
  static constexpr double kScale = 1.7320508075688772;  // sqrt(3): one over its deviation

  std::mt19937_64 generator_;
};

}  // namespace forge
