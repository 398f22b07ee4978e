#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "collision_forge/base/scene/collision_request.h"

namespace forge {

/// Bootstrap over scenes: clips of one scene are no independent samples.
struct StatisticsOptions {
  int resamples = 1000;      ///< of the scenes
  double confidence = 0.95;  ///< share of the resampled rates within an interval
  std::uint64_t seed = 1;    ///< of the resampling
};

/// One trial of something that succeeds or fails, or has another value.
struct Trial {
  std::string scene;  ///< trials of one scene depend on each other
  CollisionType type = CollisionType::kRearEnd;
  double tta = 0.0;    ///< seconds
  double value = 0.0;  ///< 1 for a success, 0 for a failure
};

struct Interval {
  double low = 0.0;
  double high = 0.0;
};

/// Scenes that an interval needs: fewer say too little about other scenes.
inline constexpr std::size_t kMinScenes = 5;

/// Successes over trials, all trials weighing the same ("pooled"); the mean of other values.
struct Rate {
  int trials = 0;
  double value = 0.0;                ///< valid with trials
  std::optional<Interval> interval;  ///< empty below kMinScenes scenes
};

/// With a bootstrap interval by scenes: as many scenes as there are, drawn with replacement, give
/// one resampled rate; the interval holds the middle `confidence` of `resamples` of them, between
/// order statistics interpolated linearly. Resamples without a trial cannot occur. Same trials and
/// seed, same interval, in whatever order the trials come (values other than 0 and 1 to
/// rounding).
Rate pooledRate(const std::vector<Trial>& trials, const StatisticsOptions& options = {});

/// The value below which a share of at least one sorted value lies, linear between them.
double quantile(const std::vector<double>& sorted, double share);

/// A set of trials that the tables have a column for.
struct TrialGroup {
  std::string title;
  std::vector<Trial> trials;
};

/// By type ("LC", "OD", "RE", "JC", "LTAP"), by TTA ("0.5-1 s", "1.5-2.5 s", "3-4.5 s", "5-6.5 s")
/// and "all", in this order. A TTA between two buckets falls into the nearer one, the earlier of
/// equals; above 7 s it falls into none.
std::vector<TrialGroup> groupTrials(const std::vector<Trial>& trials);

}  // namespace forge
