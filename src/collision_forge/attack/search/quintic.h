#pragma once

#include <array>

namespace forge {

/// State on one axis at one end of a quintic. The derivatives are with respect to the variable of
/// the polynomial: time (s), or distance (m).
struct AxisState {
  double position = 0.0;      ///< m
  double velocity = 0.0;      ///< m/s, or m/m
  double acceleration = 0.0;  ///< m/s2, or m/m2
};

/// Polynomial of degree five through two axis states (Takahashi et al. 1989).
class Quintic {
 public:
  /// `duration`: range of the variable. Throws std::invalid_argument unless it is positive.
  Quintic(const AxisState& start, const AxisState& end, double duration);

  /// Returns the state at `time` in [0, duration].
  AxisState at(double time) const;

 private:
  std::array<double, 6> coefficients_;
};

}  // namespace forge
