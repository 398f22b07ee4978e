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
  int resamples = 1000;      ///< number of resampled rates, > 0
  double confidence = 0.95;  ///< share 0..1 of the resampled rates within an interval
  std::uint64_t seed = 1;    ///< seed of the random resampling
};

/// One trial: the success or failure of an attack or rollout, or a value measured in it.
struct Trial {
  std::string scene;  ///< name of the scene; trials of one scene are dependent and form one cluster
  CollisionType type = CollisionType::kRearEnd;  ///< requested type, for groupTrials()
  double tta = 0.0;                              ///< s, requested TTA, for groupTrials()
  double value = 0.0;  ///< 1 for a success, 0 for a failure; or the measured value in its unit
};

/// Confidence interval of a rate, in its unit; its level is StatisticsOptions::confidence.
struct Interval {
  double low = 0.0;   ///< lower end
  double high = 0.0;  ///< upper end
};

/// Minimum number of distinct scenes for an interval; fewer do not generalise.
inline constexpr std::size_t kMinScenes = 5;

/// Pooled rate: successes over trials with equal weights, or the mean of the measured values.
struct Rate {
  int trials = 0;  ///< number of trials
  /// 0..1, or the mean in the unit of the values; 0 and meaningless if `trials` is 0.
  double value = 0.0;
  std::optional<Interval> interval;  ///< empty if the trials are from fewer than kMinScenes scenes
};

/// Returns the rate with a bootstrap interval over scenes: resamples the scenes with replacement
/// `options.resamples` times and takes the middle `options.confidence` of the resampled rates
/// (equal shares are cut off at both ends), with linear interpolation between order statistics.
/// Without trials, returns Rate(). Deterministic for the same trials and seed, independent of the
/// order of trials (up to rounding for values other than 0 and 1).
Rate pooledRate(const std::vector<Trial>& trials, const StatisticsOptions& options = {});

/// Returns the `share` quantile (share from 0, the least value, to 1, the greatest) of values in
/// ascending order, with linear interpolation. `sorted` must not be empty.
double quantile(const std::vector<double>& sorted, double share);

/// The trials of one table column.
struct TrialGroup {
  std::string title;          ///< column title
  std::vector<Trial> trials;  ///< in their original order
};

/// Returns the trials grouped by type (in the order of kAllCollisionTypes), then again by TTA
/// ("0.5-1 s", "1.5-2.5 s", "3-4.5 s", "5-6.5 s"), then all trials ("all"): each trial is in up to
/// three groups. Groups of the types "LC", "OD", "RE", "JC", "LTAP" are always there, even if
/// empty; a further type of kAllCollisionTypes has a group ("sideswipe same direction", ...) only
/// if it has trials. A TTA between two buckets belongs to the nearer one, the earlier if equal; a
/// TTA of 0 s or less or above 7 s belongs to no bucket. Trials keep their order.
std::vector<TrialGroup> groupTrials(const std::vector<Trial>& trials);

}  // namespace forge
