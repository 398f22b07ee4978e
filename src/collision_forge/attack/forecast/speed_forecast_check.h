#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "collision_forge/attack/forecast/speed_forecaster.h"
#include "collision_forge/attack/forecast/speed_situations.h"

namespace forge {

/// Central intervals of probability that a forecast should cover so often.
inline constexpr std::array<double, 3> kForecastIntervals = {0.5, 0.8, 0.9};

/// How well forecasts met the distances that were driven.
struct ForecastErrors {
  double horizon = 0.0;  ///< s
  std::size_t cases = 0;
  double error = 0.0;                  ///< m, mean, of the mean distance forecast
  double ranked = 0.0;                 ///< m, mean continuous ranked probability score
  std::array<double, 3> covered = {};  ///< shares within kForecastIntervals
};

/// Forecasts every row with a speed from `min_speed` to below `max_speed` (m/s), its own scene left
/// out; an entry a horizon. Rows that last less than a horizon, and rows without a forecast that
/// reaches it, are no case of it.
std::vector<ForecastErrors> checkForecasts(const SpeedSituations& recorded,
                                           const SpeedForecaster& forecaster, double min_speed,
                                           double max_speed, const std::vector<double>& horizons);

}  // namespace forge
