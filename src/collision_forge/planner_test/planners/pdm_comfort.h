#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "collision_forge/planner_test/planners/kinematic_bicycle.h"
#include "collision_forge/planner_test/planners/pdm_options.h"

namespace forge {

/// Returns the Savitzky-Golay filter (1964, doi 10.1021/ac60214a047) as a matrix. Its product with
/// `count` values, `step` seconds apart, is the derivative of order `derivative` (0: the smoothed
/// values) of the polynomial of degree `order` fitted to the `window` values around each value.
/// Within half a window of either end, uses the polynomial of the outermost window. For an even
/// window, evaluates the polynomial half a step after each value. `window` must be at most `count`
/// and more than `order`.
Eigen::MatrixXd savitzkyGolay(int count, int window, int order, int derivative, double step);

/// Signals that comfort is derived from; one value per state.
struct EgoSignals {
  std::vector<double> yaw;           ///< rad, in any turn; wrapped values are unwrapped
  std::vector<double> longitudinal;  ///< m/s2, acceleration along the heading
  std::vector<double> lateral;       ///< m/s2, acceleration to the left
};
/// Returns the signals of a simulated motion, one value per state, with a lateral acceleration of
/// 0, as published.
EgoSignals signalsOf(const std::vector<BicycleState>& states);

/// Smallest and largest value of a signal, in its unit.
struct SignalRange {
  double low = 0.0;   ///< smallest
  double high = 0.0;  ///< largest
};
/// Ranges of longitudinal acceleration, lateral acceleration (m/s2), jerk, longitudinal jerk
/// (m/s3), yaw acceleration (rad/s2) and yaw rate (rad/s), in this order.
using ComfortRanges = std::array<SignalRange, 6>;

/// Checks the comfort of motions as PDM-Closed does, on the filtered signals of nuPlan's metrics.
class PdmComfort {
 public:
  /// `states`: number of states of each motion, at least `options.yaw_window`; `step`: s between
  /// them.
  PdmComfort(int states, double step, const PdmComfortOptions& options);

  /// Filters the signals (each with one value per state of the constructor) and returns the range
  /// of each derived signal over all states. Accelerations are smoothed by one parabola over all
  /// states; jerk is the rate of their magnitude after smoothing over `jerk_window`.
  ComfortRanges ranges(const EgoSignals& signals) const;
  /// Returns, for each range in the order of ComfortRanges, whether it lies strictly within the
  /// limits of the options.
  std::array<bool, 6> keptLimits(const ComfortRanges& ranges) const;
  /// Returns whether all six ranges of the motion are within the limits. `states`: as many as in
  /// the constructor.
  bool isComfortable(const std::vector<BicycleState>& states) const;

 private:
  PdmComfortOptions options_;
  Eigen::MatrixXd acceleration_;
  Eigen::MatrixXd jerk_;
  Eigen::MatrixXd yaw_rate_;
  Eigen::MatrixXd yaw_acceleration_;
};

}  // namespace forge
