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

/// Fits a model to what was recorded outside of `left_out_scenes`:
/// - centers: k-means of the scaled features;
/// - gains: ridge regression, for each interval on the profiles that last so long;
/// - log_spreads: the same on the logarithm of how far profiles were from gains that were fitted
///   without their scene;
/// - residuals: k-means of these differences, in spreads, as distances driven;
/// - standing, standing_shares: k-means of what followed a standstill, and a ridge regression.
/// The same arguments give the same weights. Throws std::invalid_argument when fewer than two
/// scenes or too few profiles are left.
SpeedModelWeights fitSpeedModel(const SpeedSituations& recorded,
                                const std::vector<std::string>& left_out_scenes,
                                const SpeedModelFitOptions& options, std::uint64_t seed);

/// A model of all that was recorded, with `folds` others (none, or two and more) that leave each
/// scene out once. Throws std::invalid_argument for another number of folds than none, or 2 to one
/// a scene, and as fitSpeedModel(). `on_progress`, if any, is told how many of the models are
/// fitted.
SpeedModel fitSpeedModelWithFolds(
    const SpeedSituations& recorded, int folds, const SpeedModelFitOptions& options,
    std::uint64_t seed,
    const std::function<void(std::size_t done, std::size_t all)>& on_progress = {});

}  // namespace forge
