#pragma once

#include <Eigen/Core>
#include <functional>

namespace forge {

/// How much one step of integrateDormandPrince() may be wrong.
struct IntegrationTolerance {
  double relative_tolerance = 0.0;
  double absolute_tolerance = 0.0;  ///< in the unit of the state
};

/// Where an integration got to.
struct Integral {
  Eigen::Vector2d state;
  /// False where no step was small enough: `state` is that of the last good one.
  bool is_complete = true;
};

using StateRate = std::function<Eigen::Vector2d(const Eigen::Vector2d&)>;

/// The state `duration` seconds (> 0) after `start` if it changes by `rate` a second: the embedded
/// Runge-Kutta pair of order 5(4) of Dormand and Prince (1980, doi 10.1016/0771-050X(80)90013-3)
/// with steps of its own choice, chosen as SciPy 1.10's solve_ivp does with the method RK45.
Integral integrateDormandPrince(const StateRate& rate, const Eigen::Vector2d& start,
                                double duration, const IntegrationTolerance& tolerance);

}  // namespace forge
