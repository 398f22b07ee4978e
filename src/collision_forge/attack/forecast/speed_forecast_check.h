#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "collision_forge/attack/forecast/speed_forecaster.h"
#include "collision_forge/attack/forecast/speed_situations.h"

namespace forge {

/// Probabilities of the central intervals of a forecast whose coverage is measured.
inline constexpr std::array<double, 3> kForecastIntervals = {0.5, 0.8, 0.9};

/// Errors of forecast distances, driven from a frame to `horizon` later, against recorded ones.
/// Means are 0 if there are no cases.
struct ForecastErrors {
  double horizon = 0.0;   ///< s after the frame, the value given, not rounded
  std::size_t cases = 0;  ///< number of forecasts in the means
  double error = 0.0;     ///< m, mean |weighted mean of the forecast - recorded distance|
  double ranked = 0.0;    ///< m, mean continuous ranked probability score
  /// mean share 0..1 of cases within each of kForecastIntervals; a recorded distance within 0.1 m
  /// of profiles counts by the part of their probability that lies in the interval
  std::array<double, 3> covered = {};
};

/// Forecasts every row of `recorded` with a speed in [min_speed, max_speed) (m/s) with the model
/// fitted without its scene, or `forecaster` itself if there is none; returns one entry per horizon
/// (s, rounded to multiples of kProfileStep), in the order of `horizons`. A row is no case of a
/// horizon if its recording or its forecast is shorter. Throws as SpeedForecaster::forecast().
std::vector<ForecastErrors> checkForecasts(const SpeedSituations& recorded,
                                           const SpeedForecaster& forecaster, double min_speed,
                                           double max_speed, const std::vector<double>& horizons);

}  // namespace forge
