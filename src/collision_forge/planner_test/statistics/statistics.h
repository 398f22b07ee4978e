#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "collision_forge/base/scene/collision_request.h"

namespace forge {

/// Options of the bootstrap over scenes: clips of one scene are not independent samples.
struct StatisticsOptions {
  int resamples = 1000;      ///< number of resampled rates
  double confidence = 0.95;  ///< share 0..1 of the resampled rates within an interval
  std::uint64_t seed = 1;    ///< of the resampling
};

/// One trial: a success or failure, or a value.
struct Trial {
  std::string scene;  ///< cluster: trials of one scene are dependent
  CollisionType type = CollisionType::kRearEnd;
  double tta = 0.0;    ///< s
  double value = 0.0;  ///< 1 for a success, 0 for a failure
};

/// Confidence interval of a rate, in its unit; its level is StatisticsOptions::confidence.
struct Interval {
  double low = 0.0;
  double high = 0.0;
};

/// Minimum number of scenes for an interval; fewer do not generalise.
inline constexpr std::size_t kMinScenes = 5;

/// Pooled rate: successes over trials with equal weights, or the mean of other values.
struct Rate {
  int trials = 0;                    ///< number of trials
  double value = 0.0;                ///< 0..1, or the unit of the values; valid if `trials` > 0
  std::optional<Interval> interval;  ///< empty below kMinScenes scenes
};

/// Returns the rate with a bootstrap interval over scenes: resamples the scenes with replacement
/// `resamples` times and takes the middle `confidence` of the resampled rates, with linear
/// interpolation between order statistics. Deterministic for the same trials and seed, independent
/// of the order of trials (up to rounding for values other than 0 and 1).
Rate pooledRate(const std::vector<Trial>& trials, const StatisticsOptions& options = {});

/// Returns the `share` quantile (0..1) of sorted values, with linear interpolation. `sorted` must
/// not be empty.
double quantile(const std::vector<double>& sorted, double share);

/// The trials of one table column.
struct TrialGroup {
  std::string title;  ///< column title
  std::vector<Trial> trials;
};

/// Groups trials by type ("LC", "OD", "RE", "JC", "LTAP"), by TTA ("0.5-1 s", "1.5-2.5 s", "3-4.5
/// s", "5-6.5 s") and "all", in this order. A TTA between two buckets belongs to the nearer one,
/// the earlier if equal; above 7 s it belongs to none.
std::vector<TrialGroup> groupTrials(const std::vector<Trial>& trials);

}  // namespace forge
