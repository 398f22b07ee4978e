#include "collision_forge/planners/pdm_comfort.h"

#include <algorithm>
#include <cmath>

namespace forge {
namespace {

bool isWithin(const std::vector<double>& values, double low, double high) {
  return std::all_of(values.begin(), values.end(),
                     [&](double value) { return value >= low && value <= high; });
}

}  // namespace

std::vector<double> slopes(const std::vector<double>& values, int window, double step) {
  const int count = static_cast<int>(values.size());
  std::vector<double> result(values.size());
  for (int i = 0; i < count; ++i) {
    const int first = std::max(i - window / 2, 0);
    const int last = std::min(i + window / 2, count - 1);
    const double middle = 0.5 * (first + last);
    double covariance = 0.0;
    double variance = 0.0;
    for (int j = first; j <= last; ++j) {
      covariance += (j - middle) * values[static_cast<std::size_t>(j)];
      variance += (j - middle) * (j - middle);
    }
    result[static_cast<std::size_t>(i)] = covariance / (variance * step);
  }
  return result;
}

bool isComfortable(const PdmMotion& motion, const KinematicBicycle& bicycle, double step,
                   const PdmComfortOptions& options) {
  std::vector<double> longitudinal, lateral, yaw_rates;
  for (const BicycleState& state : motion.states) {
    const double yaw_rate = state.speed * bicycle.curvature(state);
    longitudinal.push_back(state.acceleration);
    lateral.push_back(state.speed * yaw_rate);
    yaw_rates.push_back(yaw_rate);
  }
  const std::vector<double> longitudinal_jerk = slopes(longitudinal, options.window, step);
  const std::vector<double> lateral_jerk = slopes(lateral, options.window, step);
  std::vector<double> jerk;
  for (std::size_t i = 0; i < motion.states.size(); ++i) {
    jerk.push_back(std::hypot(longitudinal_jerk[i], lateral_jerk[i]));
  }
  const auto within = [](const std::vector<double>& values, double limit) {
    return isWithin(values, -limit, limit);
  };
  return isWithin(longitudinal, -options.max_braking, options.max_longitudinal_acceleration) &&
         within(lateral, options.max_lateral_acceleration) && within(jerk, options.max_jerk) &&
         within(longitudinal_jerk, options.max_longitudinal_jerk) &&
         within(yaw_rates, options.max_yaw_rate) &&
         within(slopes(yaw_rates, options.window, step), options.max_yaw_acceleration);
}

}  // namespace forge
