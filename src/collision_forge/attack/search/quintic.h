#pragma once

#include <array>

namespace forge {

/// Position, velocity and acceleration on one axis at one end of a quintic.
struct AxisState {
  double position = 0.0;
  double velocity = 0.0;
  double acceleration = 0.0;
};

/// The polynomial of degree five through two axis states (Takahashi et al. 1989).
class Quintic {
 public:
  /// `duration` in seconds, > 0; throws std::invalid_argument otherwise.
  Quintic(const AxisState& start, const AxisState& end, double duration);

  /// State at `time` in [0, duration].
  AxisState at(double time) const;

 private:
  std::array<double, 6> coefficients_;
};

}  // namespace forge
