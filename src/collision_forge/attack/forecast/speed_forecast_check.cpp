#include "collision_forge/attack/forecast/speed_forecast_check.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace forge {
namespace {

constexpr double kSameDistance = 0.1;  // m; smaller differences count as equal

/// Returns the part of the rank interval [low, high] that lies in the central interval of
/// probability `interval`.
double shareWithin(double low, double high, double interval) {
  const double from = 0.5 - 0.5 * interval;
  const double to = 0.5 + 0.5 * interval;
  if (high - low < 1e-9) return low >= from && low <= to ? 1.0 : 0.0;
  return std::max(std::min(high, to) - std::max(low, from), 0.0) / (high - low);
}

/// Adds one case to `sums`, which divided() later turns into means.
void add(const Eigen::VectorXd& driven, const Eigen::VectorXd& weights, double recorded,
         ForecastErrors& sums) {
  std::vector<Eigen::Index> order(static_cast<std::size_t>(driven.size()));
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&](Eigen::Index a, Eigen::Index b) { return driven[a] < driven[b]; });
  double below = 0.0;   // share of the profiles up to the one before
  double spread = 0.0;  // half the mean difference between two profiles
  double before = driven[order.front()];
  for (const Eigen::Index i : order) {
    spread += (driven[i] - before) * below * (1.0 - below);
    below += weights[i];
    before = driven[i];
  }
  const auto shorter = (driven.array() < recorded - kSameDistance).select(weights, 0.0).sum();
  const auto longer = (driven.array() > recorded + kSameDistance).select(weights, 0.0).sum();
  ++sums.cases;
  sums.error += std::abs(weights.dot(driven) - recorded);
  sums.ranked += weights.dot((driven.array() - recorded).abs().matrix()) - spread;
  for (std::size_t i = 0; i < kForecastIntervals.size(); ++i) {
    sums.covered[i] += shareWithin(shorter, 1.0 - longer, kForecastIntervals[i]);
  }
}

ForecastErrors divided(ForecastErrors sums) {
  const double cases = std::max(static_cast<double>(sums.cases), 1.0);
  sums.error /= cases;
  sums.ranked /= cases;
  for (double& covered : sums.covered) covered /= cases;
  return sums;
}

}  // namespace

std::vector<ForecastErrors> checkForecasts(const SpeedSituations& recorded,
                                           const SpeedForecaster& forecaster, double min_speed,
                                           double max_speed, const std::vector<double>& horizons) {
  std::vector<ForecastErrors> errors;
  int longest = 0;
  for (const double horizon : horizons) {
    errors.push_back({horizon});
    longest = std::max(longest, static_cast<int>(std::lround(horizon / kProfileStep)));
  }
  for (Eigen::Index row = 0; row < recorded.size(); ++row) {
    if (!(recorded.speed(row) >= min_speed && recorded.speed(row) < max_speed)) continue;
    const std::string& scene = recorded.scenes()[static_cast<std::size_t>(recorded.sceneOf(row))];
    const auto other = forecaster.withoutScene(scene);
    const SpeedForecast forecast =
        (other ? *other : forecaster).forecast(recorded.situation(row), longest);
    for (ForecastErrors& sums : errors) {
      const int intervals = static_cast<int>(std::lround(sums.horizon / kProfileStep));
      if (recorded.intervalsAfter(row) < intervals || forecast.speeds.cols() < intervals) continue;
      double driven = 0.0;
      for (int i = 0; i < intervals; ++i) driven += recorded.speed(row + i + 1) * kProfileStep;
      add(kProfileStep * forecast.speeds.leftCols(intervals).rowwise().sum(), forecast.weights,
          driven, sums);
    }
  }
  std::transform(errors.begin(), errors.end(), errors.begin(), divided);
  return errors;
}

}  // namespace forge
