#pragma once

#include <Eigen/Core>
#include <functional>

namespace forge {

/// Error tolerance of one step of integrateDormandPrince(), for each component of the state:
/// absolute_tolerance + relative_tolerance * |component|.
struct IntegrationTolerance {
  double relative_tolerance = 0.0;  ///< share of the component's magnitude
  double absolute_tolerance = 0.0;  ///< in the unit of the component
};

/// Result of an integration.
struct Integral {
  Eigen::Vector2d state;  ///< at the end of the integration
  /// False if even the smallest step exceeded the tolerance; `state` is then the last accepted one.
  bool is_complete = true;
};

/// Returns the derivative of a state with respect to time, per second. It depends on the state
/// only.
using StateRate = std::function<Eigen::Vector2d(const Eigen::Vector2d&)>;

/// Integrates `rate` from `start` over `duration` seconds (> 0) with the embedded Runge-Kutta pair
/// of order 5(4) of Dormand and Prince (1980, doi 10.1016/0771-050X(80)90013-3). Controls the step
/// size as SciPy 1.10's solve_ivp does with the method RK45. Calls `rate` several times per step,
/// on the calling thread.
Integral integrateDormandPrince(const StateRate& rate, const Eigen::Vector2d& start,
                                double duration, const IntegrationTolerance& tolerance);

}  // namespace forge
