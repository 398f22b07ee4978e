#include "collision_forge/planner_test/statistics/statistics.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

namespace forge {
namespace {

struct Sum {
  double values = 0.0;
  int trials = 0;
};

/// Short names of the published types, as in the requests' grammar.
const char* shortName(CollisionType type) {
  switch (type) {
    case CollisionType::kLaneChange:
      return "LC";
    case CollisionType::kOppositeDirection:
      return "OD";
    case CollisionType::kRearEnd:
      return "RE";
    case CollisionType::kJunctionCrossing:
      return "JC";
    case CollisionType::kLtap:
      return "LTAP";
    case CollisionType::kSideswipeSameDirection:
      return "sideswipe same direction";
    case CollisionType::kAngleSameDirection:
      return "angle same direction";
    case CollisionType::kAngleOppositeDirection:
      return "angle opposite direction";
    case CollisionType::kAny:
      break;
  }
  return "unknown";
}

struct TtaBucket {
  const char* title;
  double last;  ///< s, largest TTA in the bucket
};

/// Buckets of the protocol, whose TTAs are multiples of 0.5 s; borders are midway.
constexpr TtaBucket kTtaBuckets[] = {
    {"0.5-1 s", 1.25}, {"1.5-2.5 s", 2.75}, {"3-4.5 s", 4.75}, {"5-6.5 s", 7.0}};

std::vector<Sum> sumByScene(const std::vector<Trial>& trials) {
  std::map<std::string, Sum> by_scene;
  for (const Trial& trial : trials) {
    Sum& sum = by_scene[trial.scene];
    sum.values += trial.value;
    ++sum.trials;
  }
  std::vector<Sum> sums;
  for (const auto& entry : by_scene) sums.push_back(entry.second);
  return sums;
}

double meanOf(const Sum& sum) { return sum.values / sum.trials; }

template <typename Predicate>
std::vector<Trial> selected(const std::vector<Trial>& trials, Predicate predicate) {
  std::vector<Trial> found;
  std::copy_if(trials.begin(), trials.end(), std::back_inserter(found), predicate);
  return found;
}

}  // namespace

double quantile(const std::vector<double>& sorted, double share) {
  const double place = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (place - std::floor(place)) * (sorted[above] - sorted[below]);
}

Rate pooledRate(const std::vector<Trial>& trials, const StatisticsOptions& options) {
  if (trials.empty()) return {};
  const std::vector<Sum> scenes = sumByScene(trials);
  Sum all;
  for (const Sum& scene : scenes) {
    all.values += scene.values;
    all.trials += scene.trials;
  }
  if (scenes.size() < kMinScenes) return {all.trials, meanOf(all), std::nullopt};
  std::mt19937_64 generator(options.seed);
  std::vector<double> rates;
  for (int resample = 0; resample < options.resamples; ++resample) {
    Sum sum;
    for (std::size_t draw = 0; draw < scenes.size(); ++draw) {
      // Standard distributions differ between libraries; the generator does not.
      const Sum& scene = scenes[generator() % scenes.size()];
      sum.values += scene.values;
      sum.trials += scene.trials;
    }
    rates.push_back(meanOf(sum));
  }
  std::sort(rates.begin(), rates.end());
  const double outside = 0.5 * (1.0 - options.confidence);
  return {all.trials, meanOf(all),
          Interval{quantile(rates, outside), quantile(rates, 1.0 - outside)}};
}

std::vector<TrialGroup> groupTrials(const std::vector<Trial>& trials) {
  std::vector<TrialGroup> groups;
  for (const CollisionType type : kAllCollisionTypes) {
    std::vector<Trial> own =
        selected(trials, [=](const Trial& trial) { return trial.type == type; });
    if (isPublished(type) || !own.empty()) groups.push_back({shortName(type), std::move(own)});
  }
  double after = 0.0;
  for (const TtaBucket& bucket : kTtaBuckets) {
    groups.push_back({bucket.title, selected(trials, [=](const Trial& trial) {
                        return trial.tta > after && trial.tta <= bucket.last;
                      })});
    after = bucket.last;
  }
  groups.push_back({"all", trials});
  return groups;
}

}  // namespace forge
