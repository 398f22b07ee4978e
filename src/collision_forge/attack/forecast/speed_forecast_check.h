#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "collision_forge/attack/forecast/speed_forecaster.h"
#include "collision_forge/attack/forecast/speed_situations.h"

namespace forge {

/// Probabilities of the central intervals whose coverage is measured.
inline constexpr std::array<double, 3> kForecastIntervals = {0.5, 0.8, 0.9};

/// Errors of forecast distances against recorded ones.
struct ForecastErrors {
  double horizon = 0.0;                ///< s
  std::size_t cases = 0;               ///< number of forecasts
  double error = 0.0;                  ///< m, mean |mean forecast - recorded distance|
  double ranked = 0.0;                 ///< m, mean continuous ranked probability score
  std::array<double, 3> covered = {};  ///< share 0..1 of cases within kForecastIntervals
};

/// Forecasts every row with a speed in [min_speed, max_speed) (m/s) with the model fitted without
/// its scene; returns one entry per horizon (s). A row is no case of a horizon if its recording or
/// its forecast is shorter.
std::vector<ForecastErrors> checkForecasts(const SpeedSituations& recorded,
                                           const SpeedForecaster& forecaster, double min_speed,
                                           double max_speed, const std::vector<double>& horizons);

}  // namespace forge
