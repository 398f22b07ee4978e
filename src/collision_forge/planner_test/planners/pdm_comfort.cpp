#include "collision_forge/planner_test/planners/pdm_comfort.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

namespace forge {
namespace {

/// Returns the weight of each of `window` values in the value at `place` (steps from the window's
/// middle) of the polynomial fitted to them.
Eigen::RowVectorXd weightsAt(double place, int window, int order, int derivative, double step) {
  Eigen::MatrixXd powers(window, order + 1);
  for (int i = 0; i < window; ++i) {
    const double offset = i - 0.5 * (window - 1);
    for (int power = 0; power <= order; ++power) powers(i, power) = std::pow(offset, power);
  }
  Eigen::RowVectorXd asked = Eigen::RowVectorXd::Zero(order + 1);
  for (int power = derivative; power <= order; ++power) {
    double factor = std::pow(place, power - derivative);
    for (int i = 0; i < derivative; ++i) factor *= power - i;
    asked(power) = factor / std::pow(step, derivative);
  }
  return asked * powers.colPivHouseholderQr().solve(Eigen::MatrixXd::Identity(window, window));
}

SignalRange rangeOf(const Eigen::VectorXd& values) {
  return {values.minCoeff(), values.maxCoeff()};
}

Eigen::VectorXd vectorOf(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

}  // namespace

EgoSignals signalsOf(const std::vector<BicycleState>& states) {
  EgoSignals signals;
  for (const BicycleState& state : states) {
    signals.yaw.push_back(state.rear_axle.yaw);
    signals.longitudinal.push_back(state.acceleration);
    signals.lateral.push_back(0.0);
  }
  return signals;
}

Eigen::MatrixXd savitzkyGolay(int count, int window, int order, int derivative, double step) {
  Eigen::MatrixXd filter = Eigen::MatrixXd::Zero(count, count);
  const int half = window / 2;
  const double middle = 0.5 * (window - 1);
  for (int i = 0; i < count; ++i) {
    const bool is_inner = i >= half && i < count - half;
    const int first = is_inner ? i - (window - 1) / 2 : i < half ? 0 : count - window;
    const double place = is_inner ? 0.0 : i - first - middle;
    filter.block(i, first, 1, window) = weightsAt(place, window, order, derivative, step);
  }
  return filter;
}

PdmComfort::PdmComfort(int states, double step, const PdmComfortOptions& options)
    : options_(options),
      acceleration_(savitzkyGolay(states, states, 2, 0, step)),
      jerk_(savitzkyGolay(states, states, 2, 1, step) *
            savitzkyGolay(states, std::min(options.jerk_window, states), 2, 0, step)),
      yaw_rate_(savitzkyGolay(states, options.yaw_window, 2, 1, step)),
      yaw_acceleration_(savitzkyGolay(states, options.yaw_window, 3, 2, step)) {}

ComfortRanges PdmComfort::ranges(const EgoSignals& signals) const {
  const Eigen::VectorXd longitudinal = vectorOf(signals.longitudinal);
  const Eigen::VectorXd lateral = vectorOf(signals.lateral);
  Eigen::VectorXd yaw = vectorOf(signals.yaw);
  for (Eigen::Index i = 1; i < yaw.size(); ++i)
    yaw(i) = yaw(i - 1) + angleBetween(yaw(i - 1), yaw(i));
  const Eigen::VectorXd magnitude = (longitudinal.cwiseAbs2() + lateral.cwiseAbs2()).cwiseSqrt();
  return {rangeOf(acceleration_ * longitudinal),
          rangeOf(acceleration_ * lateral),
          rangeOf(jerk_ * magnitude),
          rangeOf(jerk_ * longitudinal),
          rangeOf(yaw_acceleration_ * yaw),
          rangeOf(yaw_rate_ * yaw)};
}

std::array<bool, 6> PdmComfort::keptLimits(const ComfortRanges& ranges) const {
  const std::array<SignalRange, 6> limits = {{
      {-options_.max_braking, options_.max_longitudinal_acceleration},
      {-options_.max_lateral_acceleration, options_.max_lateral_acceleration},
      {-options_.max_jerk, options_.max_jerk},
      {-options_.max_longitudinal_jerk, options_.max_longitudinal_jerk},
      {-options_.max_yaw_acceleration, options_.max_yaw_acceleration},
      {-options_.max_yaw_rate, options_.max_yaw_rate},
  }};
  std::array<bool, 6> kept{};
  for (std::size_t i = 0; i < kept.size(); ++i) {
    kept[i] = ranges[i].low > limits[i].low && ranges[i].high < limits[i].high;
  }
  return kept;
}

bool PdmComfort::isComfortable(const std::vector<BicycleState>& states) const {
  const std::array<bool, 6> kept = keptLimits(ranges(signalsOf(states)));
  return std::all_of(kept.begin(), kept.end(), [](bool is_kept) { return is_kept; });
}

}  // namespace forge
