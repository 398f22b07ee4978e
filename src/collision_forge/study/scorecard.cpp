#include "collision_forge/study/scorecard.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include "collision_forge/study/motion_features.h"
#include "collision_forge/study/scene_halves.h"

namespace forge {
namespace {

/// What a match has in common with its attack.
using Kind = std::pair<ClassGroup, SpeedBand>;

Kind kindOf(const DescribedMotion& motion) { return {motion.group, motion.band}; }

/// Recorded motions, each given away once.
class RecordedPool {
 public:
  RecordedPool(const std::vector<DescribedMotion>& recorded, std::mt19937_64& generator)
      : recorded_(recorded), taken_(recorded.size(), false) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < recorded.size(); ++i) order.push_back(i);
    shuffle(order, generator);
    for (const std::size_t i : order) {
      of_kind_[kindOf(recorded[i])].push_back(i);
      of_scene_[{kindOf(recorded[i]), recorded[i].scene}].push_back(i);
    }
  }

  const DescribedMotion* takeOfScene(const DescribedMotion& attack) {
    return take(of_scene_[{kindOf(attack), attack.scene}]);
  }
  const DescribedMotion* takeOfKind(const DescribedMotion& attack) {
    return take(of_kind_[kindOf(attack)]);
  }

 private:
  /// The last that is not taken yet; nobody where none is left.
  const DescribedMotion* take(std::vector<std::size_t>& left) {
    while (!left.empty()) {
      const std::size_t i = left.back();
      left.pop_back();
      if (taken_[i]) continue;
      taken_[i] = true;
      return &recorded_[i];
    }
    return nullptr;
  }

  const std::vector<DescribedMotion>& recorded_;
  std::vector<bool> taken_;
  std::map<Kind, std::vector<std::size_t>> of_kind_;
  std::map<std::pair<Kind, std::string>, std::vector<std::size_t>> of_scene_;
};

/// All motion of one scorecard.
struct ScoredMotion {
  std::vector<DescribedMotion> attacks;
  std::vector<DescribedMotion> noisy;  // the same attacks with noise, in the same cells
  std::vector<DescribedMotion> recorded;
};

ScoredMotion ofGroupAndBand(const ScoredMotion& motion, ClassGroup group, SpeedBand band) {
  return {ofGroupAndBand(motion.attacks, group, band), ofGroupAndBand(motion.noisy, group, band),
          ofGroupAndBand(motion.recorded, group, band)};
}

std::vector<DistanceRow> distanceRows(const ScoredMotion& all, ClassGroup group, SpeedBand band,
                                      const ScorecardOptions& options) {
  const auto [attacks, noisy_attacks, recorded] = ofGroupAndBand(all, group, band);
  const auto least = static_cast<std::size_t>(options.min_windows);
  if (attacks.size() < least || recorded.size() < least) return {};
  const auto floors =
      distanceFloors(recorded, {options.draws, attacks.size(), options.seed}, options.quantiles);
  std::vector<DistanceRow> rows;
  for (std::size_t i = 0; i < kMotionQuantities.size(); ++i) {
    const auto distance = distanceOf(attacks, recorded, kMotionQuantities[i], options.quantiles);
    const auto noisy = distanceOf(noisy_attacks, recorded, kMotionQuantities[i], options.quantiles);
    if (!distance || !noisy || !floors[i]) continue;
    rows.push_back({kMotionQuantities[i], group, band, attacks.size(), recorded.size(), *distance,
                    *noisy, *floors[i]});
  }
  return rows;
}

/// Of a half of recorded motion as many of each kind as there are attacks, or all there are.
std::vector<DescribedMotion> drawLike(const std::vector<DescribedMotion>& attacks,
                                      const std::vector<DescribedMotion>& half,
                                      std::mt19937_64& generator) {
  RecordedPool pool(half, generator);
  std::vector<DescribedMotion> drawn;
  for (const DescribedMotion& attack : attacks) {
    const DescribedMotion* found = pool.takeOfKind(attack);
    if (found != nullptr) drawn.push_back(*found);
  }
  return drawn;
}

std::optional<TwoSampleTest> testMatched(const MatchedMotion& matched,
                                         const ScorecardOptions& options, std::uint64_t seed) {
  const auto least = static_cast<std::size_t>(options.min_windows);
  if (matched.attacks.size() < least || matched.recorded.size() < least) return std::nullopt;
  return testTwoSamples(featuresOf(matched.attacks), featuresOf(matched.recorded),
                        options.classifier, seed);
}

/// Tests of recorded motion in the attacks' place, one a draw that is large enough.
std::vector<TwoSampleTest> floorTests(const std::vector<DescribedMotion>& attacks,
                                      const std::vector<DescribedMotion>& recorded,
                                      const ScorecardOptions& options, std::mt19937_64& generator) {
  std::vector<TwoSampleTest> tests;
  for (int draw = 0; draw < options.draws; ++draw) {
    const HalvedMotion halves = drawHalves(recorded, generator);
    const MatchedMotion matched = matchRecorded(drawLike(attacks, halves[0], generator), halves[1],
                                                options.matched, generator);
    const auto test = testMatched(matched, options, generator());
    if (test) tests.push_back(*test);
  }
  return tests;
}

template <class Measure>
RecordedFloor floorOfTests(const std::vector<TwoSampleTest>& tests, Measure measure) {
  std::vector<double> areas;
  for (const TwoSampleTest& test : tests) areas.push_back(measure(test));
  return floorOf(areas);
}

std::optional<ClassifierRow> classifierRow(const ScoredMotion& all, ClassGroup group,
                                           const ScorecardOptions& options) {
  const auto [attacks, noisy_attacks, recorded] = ofGroupAndBand(all, group, SpeedBand::kAll);
  // Both draw the same matches and halves.
  std::mt19937_64 generator(options.seed), same(options.seed);
  const MatchedMotion matched = matchRecorded(attacks, recorded, options.matched, generator);
  const MatchedMotion noisy_matched = matchRecorded(noisy_attacks, recorded, options.matched, same);
  const auto test = testMatched(matched, options, generator());
  const auto noisy = testMatched(noisy_matched, options, same());
  if (!test || !noisy) return std::nullopt;
  const auto floors = floorTests(matched.attacks, recorded, options, generator);
  if (floors.empty()) return std::nullopt;
  return ClassifierRow{
      group,
      *test,
      *noisy,
      matched.unmatched,
      floorOfTests(floors, [](const TwoSampleTest& drawn) { return drawn.logistic; }),
      floorOfTests(floors, [](const TwoSampleTest& drawn) { return drawn.forest; }),
      floorOfTests(floors, [](const TwoSampleTest& drawn) { return drawn.larger(); })};
}

}  // namespace

MatchedMotion matchRecorded(const std::vector<DescribedMotion>& attacks,
                            const std::vector<DescribedMotion>& recorded, int wanted,
                            std::mt19937_64& generator) {
  RecordedPool pool(recorded, generator);
  MatchedMotion matched;
  std::vector<int> found(attacks.size(), 0);
  const auto fill = [&](const auto& take) {
    for (int round = 0; round < wanted; ++round) {
      for (std::size_t i = 0; i < attacks.size(); ++i) {
        if (found[i] > round) continue;
        const DescribedMotion* match = take(attacks[i]);
        if (match == nullptr) continue;
        matched.recorded.push_back(*match);
        ++found[i];
      }
    }
  };
  fill([&](const DescribedMotion& attack) { return pool.takeOfScene(attack); });
  fill([&](const DescribedMotion& attack) { return pool.takeOfKind(attack); });
  for (std::size_t i = 0; i < attacks.size(); ++i) {
    if (found[i] > 0) {
      matched.attacks.push_back(attacks[i]);
    } else {
      ++matched.unmatched;
    }
  }
  return matched;
}

Scorecard scorecardOf(const std::vector<MotionWindow>& attacks,
                      const std::vector<MotionWindow>& recorded, const ScorecardOptions& options) {
  std::vector<MotionWindow> counted;
  for (const MotionWindow& window : attacks) {
    if (window.generated >= static_cast<std::size_t>(options.min_generated)) {
      counted.push_back(window);
    }
  }
  std::mt19937_64 generator(options.seed);
  ScoredMotion motion;
  motion.attacks = describeMotion(counted, options.motion);
  motion.noisy = describeMotion(withRecordedNoise(counted, recorded, generator), options.motion);
  motion.recorded = describeMotion(recorded, options.motion);
  for (std::size_t i = 0; i < counted.size(); ++i) motion.noisy[i].band = motion.attacks[i].band;
  Scorecard card;
  card.attacks = counted.size();
  card.left_out = attacks.size() - counted.size();
  card.recorded = recorded.size();
  for (const ClassGroup group : kClassGroups) {
    for (const SpeedBand band : kSpeedBands) {
      const auto rows = distanceRows(motion, group, band, options);
      card.distances.insert(card.distances.end(), rows.begin(), rows.end());
    }
    const auto row = classifierRow(motion, group, options);
    if (row) card.classifiers.push_back(*row);
  }
  return card;
}

}  // namespace forge
