#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "collision_forge/attack/forecast/options.h"
#include "collision_forge/attack/forecast/speed_model.h"
#include "collision_forge/attack/forecast/speed_situations.h"

namespace forge {

/// Fits a model to all scenes of `recorded` except `left_out_scenes` (names; unknown ones are
/// ignored):
/// - centers: k-means of the scaled features;
/// - gains: ridge regression, per interval over the profiles that are long enough;
/// - log_spreads: ridge regression of the log |residual|, residuals from gains fitted without the
///   scene;
/// - residuals: k-means of the residuals in spreads, accumulated over time;
/// - standing, standing_shares: k-means of profiles after a standstill, and a ridge regression;
///   empty if fewer than 8 such profiles are recorded.
///
/// Intervals from the first one with fewer than 40 profiles of moving egos on are dropped. The
/// result's left_out_scenes is `left_out_scenes`. Deterministic in its arguments. Throws
/// std::invalid_argument if fewer than two scenes with moving egos, or fewer than 40 profiles of
/// moving egos, remain.
SpeedModelWeights fitSpeedModel(const SpeedSituations& recorded,
                                const std::vector<std::string>& left_out_scenes,
                                const SpeedModelFitOptions& options, std::uint64_t seed);

/// Fits a model to all scenes, and `folds` models, each without one of as many random groups of
/// scenes, whose sizes differ by at most one. `folds` must be 0 or 2 to the number of scenes;
/// throws std::invalid_argument otherwise and as fitSpeedModel(). Calls `on_progress`, if set,
/// after each model on the caller's thread, with the number of fitted models and of all models
/// (`folds` + 1).
SpeedModel fitSpeedModelWithFolds(
    const SpeedSituations& recorded, int folds, const SpeedModelFitOptions& options,
    std::uint64_t seed,
    const std::function<void(std::size_t done, std::size_t all)>& on_progress = {});

}  // namespace forge
