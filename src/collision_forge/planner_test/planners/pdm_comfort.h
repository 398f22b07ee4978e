#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "collision_forge/planner_test/planners/kinematic_bicycle.h"
#include "collision_forge/planner_test/planners/pdm_options.h"

namespace forge {

/// The filter of Savitzky and Golay (1964, doi 10.1021/ac60214a047) as a matrix: times `count`
/// values that follow each other every `step` seconds, it gives the derivative of that order (0:
/// the values themselves) of the polynomial that fits the `window` values around each best. Within
/// half a window of either end it is the polynomial of the outermost window. The polynomial of an
/// even window is asked half a step after each value. `window` is at most `count` and more than
/// `order`.
Eigen::MatrixXd savitzkyGolay(int count, int window, int order, int derivative, double step);

/// What comfort is told from: a value a state.
struct EgoSignals {
  std::vector<double> yaw;           ///< rad
  std::vector<double> longitudinal;  ///< m/s2
  std::vector<double> lateral;       ///< m/s2
};
/// Of a motion as it is simulated, where the lateral acceleration is 0.
EgoSignals signalsOf(const std::vector<BicycleState>& states);

struct SignalRange {
  double low = 0.0;
  double high = 0.0;
};
/// Of longitudinal and lateral acceleration (m/s2), jerk and longitudinal jerk (m/s3), yaw
/// acceleration (rad/s2) and yaw rate (rad/s), in this order.
using ComfortRanges = std::array<SignalRange, 6>;

/// Tells whether motions are comfortable, as PDM-Closed does: signals of nuPlan's metrics,
/// filtered.
class PdmComfort {
 public:
  /// For motions of `states` states, one every `step` seconds; no fewer than a window.
  PdmComfort(int states, double step, const PdmComfortOptions& options);

  ComfortRanges ranges(const EgoSignals& signals) const;
  std::array<bool, 6> keptLimits(const ComfortRanges& ranges) const;
  bool isComfortable(const std::vector<BicycleState>& states) const;

 private:
  PdmComfortOptions options_;
  Eigen::MatrixXd acceleration_;
  Eigen::MatrixXd jerk_;
  Eigen::MatrixXd yaw_rate_;
  Eigen::MatrixXd yaw_acceleration_;
};

}  // namespace forge
