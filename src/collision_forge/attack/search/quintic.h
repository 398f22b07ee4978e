#pragma once

#include <array>

namespace forge {

/// Position, velocity and acceleration on one axis at one end of a quintic.
struct AxisState {
  double position = 0.0;      ///< m, or another unit that the caller chooses
  double velocity = 0.0;      ///< unit of `position` per s
  double acceleration = 0.0;  ///< unit of `position` per s2
};

/// Polynomial of degree five through two axis states (Takahashi et al. 1989).
class Quintic {
 public:
  /// Starts in `start` at time 0 and is in `end` at `duration`. Throws std::invalid_argument unless
  /// `duration` > 0 (s).
  Quintic(const AxisState& start, const AxisState& end, double duration);

  /// Returns the state at `time` in [0, duration], s; times outside extrapolate the polynomial.
  AxisState at(double time) const;

 private:
  std::array<double, 6> coefficients_;
};

}  // namespace forge
