#include "collision_forge/study/scorecard.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "study/test_windows.h"

namespace forge {
namespace {

const ScorecardOptions kOptions = shippedScorecardOptions();

std::vector<DescribedMotion> describe(const std::vector<MotionWindow>& windows) {
  return describeMotion(windows, kOptions.motion);
}

MatchedMotion match(const std::vector<MotionWindow>& attacks,
                    const std::vector<MotionWindow>& recorded, int wanted) {
  std::mt19937_64 generator(1);
  return matchRecorded(describe(attacks), describe(recorded), wanted, generator);
}

std::vector<std::string> scenesOf(const std::vector<DescribedMotion>& motions) {
  std::vector<std::string> scenes;
  for (const DescribedMotion& motion : motions) scenes.push_back(motion.scene);
  std::sort(scenes.begin(), scenes.end());
  return scenes;
}

using Scenes = std::vector<std::string>;

TEST(MatchRecorded, TakesTheOwnSceneFirst) {
  const auto matched = match({simpleWindow("b", 8.0, 0.0)},
                             {simpleWindow("a", 8.0, 0.0), simpleWindow("b", 7.0, 0.0),
                              simpleWindow("b", 6.0, 0.0), simpleWindow("c", 8.0, 0.0)},
                             2);
  EXPECT_EQ(scenesOf(matched.recorded), (Scenes{"b", "b"}));
  EXPECT_EQ(matched.unmatched, 0u);
}

TEST(MatchRecorded, TakesOtherScenesWhereTheOwnHasTooFew) {
  const auto matched = match({simpleWindow("b", 8.0, 0.0)},
                             {simpleWindow("a", 8.0, 0.0), simpleWindow("b", 7.0, 0.0)}, 2);
  EXPECT_EQ(scenesOf(matched.recorded), (Scenes{"a", "b"}));
}

TEST(MatchRecorded, GivesEachAwayOnceAndFairly) {
  const auto matched =
      match({simpleWindow("b", 8.0, 0.0), simpleWindow("b", 8.0, 1.0), simpleWindow("b", 8.0, 2.0)},
            {simpleWindow("b", 8.0, 0.0), simpleWindow("b", 7.0, 0.0)}, 3);
  EXPECT_EQ(matched.recorded.size(), 2u);
  EXPECT_EQ(matched.attacks.size(), 2u);
  EXPECT_EQ(matched.unmatched, 1u);
}

TEST(MatchRecorded, MatchesGroupAndBand) {
  std::vector<MotionWindow> attacks = {simpleWindow("a", 8.0, 0.0), simpleWindow("a", 8.0, 0.0)};
  attacks[1].agent_class = AgentClass::kBus;
  std::vector<MotionWindow> recorded = {simpleWindow("a", 4.0, 0.0), simpleWindow("b", 8.0, 0.0)};
  const auto matched = match(attacks, recorded, 3);
  EXPECT_EQ(scenesOf(matched.recorded), Scenes{"b"});
  ASSERT_EQ(matched.attacks.size(), 1u);
  EXPECT_EQ(matched.attacks[0].group, ClassGroup::kCar);
  EXPECT_EQ(matched.unmatched, 1u);
}

/// Of the acceleration of all in all bands.
const DistanceRow& accelerationRow(const Scorecard& card) {
  return *std::find_if(card.distances.begin(), card.distances.end(), [](const DistanceRow& row) {
    return row.quantity == MotionQuantity::kAcceleration && row.group == ClassGroup::kAll &&
           row.band == SpeedBand::kAll;
  });
}

TEST(Scorecard, AttackersAsRecordedAreAtTheFloor) {
  constexpr std::uint64_t kSeed = 2;
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  std::mt19937_64 generator(kSeed);
  const auto attacks = drawnWindows(40, 3, 0.0, generator);
  const Scorecard card = scorecardOf(attacks, drawnWindows(40, 20, 0.0, generator), kOptions);
  const DistanceRow& row = accelerationRow(card);
  EXPECT_LT(row.distance.wasserstein, 1.5 * row.floor.wasserstein.max);
  ASSERT_FALSE(card.classifiers.empty());
  const ClassifierRow& all = card.classifiers.front();
  EXPECT_EQ(all.test.first, 120u);
  EXPECT_EQ(all.test.second, 360u);
  EXPECT_NEAR(all.test.logistic, 0.5, 3.0 * all.test.standard_error);
  EXPECT_NEAR(all.test.forest, 0.5, 3.0 * all.test.standard_error);
  EXPECT_NEAR(all.larger_floor.mean, 0.5, 3.0 * all.test.standard_error);
  EXPECT_GE(all.larger_floor.mean, all.logistic_floor.mean);
  EXPECT_GE(all.larger_floor.mean, all.forest_floor.mean);
}

TEST(Scorecard, AttackersThatBrakeHarderAreFarAboveTheFloor) {
  constexpr std::uint64_t kSeed = 3;
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  std::mt19937_64 generator(kSeed);
  const auto attacks = drawnWindows(40, 3, -2.0, generator);
  const Scorecard card = scorecardOf(attacks, drawnWindows(40, 20, 0.0, generator), kOptions);
  const DistanceRow& row = accelerationRow(card);
  EXPECT_NEAR(row.distance.wasserstein, 2.0, 0.3);
  EXPECT_GT(row.distance.wasserstein, 5.0 * row.floor.wasserstein.max);
  EXPECT_GT(row.distance.jensen_shannon, 5.0 * row.floor.jensen_shannon.max);
  EXPECT_GT(card.classifiers.front().test.logistic, 0.9);
  EXPECT_GT(card.classifiers.front().test.forest, 0.9);
  EXPECT_LT(card.classifiers.front().larger_floor.max, 0.7);
}

TEST(Scorecard, SmoothAttackersAreAlikeWithTheRecordingsNoise) {
  constexpr std::uint64_t kSeed = 7;
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  std::mt19937_64 generator(kSeed);
  const auto attacks = drawnWindows(40, 3, 0.0, generator);
  auto recorded = drawnWindows(40, 20, 0.0, generator);
  std::normal_distribution<double> noise(0.0, 0.3);
  for (MotionWindow& window : recorded) {
    for (WindowSample& sample : window.samples) sample.pose.x += noise(generator);
  }
  const ClassifierRow all = scorecardOf(attacks, recorded, kOptions).classifiers.front();
  EXPECT_GT(all.test.larger(), 0.8);
  EXPECT_NEAR(all.noisy.larger(), 0.5, 3.0 * all.noisy.standard_error);
  const DistanceRow jerk = scorecardOf(attacks, recorded, kOptions).distances[2];
  ASSERT_EQ(jerk.quantity, MotionQuantity::kJerk);
  EXPECT_GT(jerk.distance.wasserstein, 3.0 * jerk.noisy.wasserstein);
}

TEST(Scorecard, RowsAreOfCellsWithEnoughWindows) {
  std::mt19937_64 generator(4);
  const auto recorded = drawnWindows(10, 10, 0.0, generator);
  const Scorecard card = scorecardOf(drawnWindows(10, 5, 0.0, generator), recorded, kOptions);
  // Cars at 6 to 9 m/s: all and car, of all bands and of one.
  EXPECT_EQ(card.distances.size(), 2 * 2 * kMotionQuantities.size());
  for (const DistanceRow& row : card.distances) {
    EXPECT_TRUE(row.group == ClassGroup::kAll || row.group == ClassGroup::kCar);
    EXPECT_TRUE(row.band == SpeedBand::kAll || row.band == SpeedBand::kMedium);
    EXPECT_EQ(row.attacks, 50u);
    EXPECT_EQ(row.recorded, 100u);
  }
  EXPECT_EQ(card.classifiers.size(), 2u);
  const Scorecard few = scorecardOf(drawnWindows(10, 2, 0.0, generator), recorded, kOptions);
  EXPECT_TRUE(few.distances.empty());
  EXPECT_TRUE(few.classifiers.empty());
}

TEST(Scorecard, AttacksThatAreMostlyRecordedDoNotCount) {
  std::mt19937_64 generator(5);
  auto attacks = drawnWindows(10, 5, 0.0, generator);
  for (std::size_t i = 0; i < 7; ++i) {
    attacks[i].generated = static_cast<std::size_t>(kOptions.min_generated) - 1;
  }
  const Scorecard card = scorecardOf(attacks, drawnWindows(10, 10, 0.0, generator), kOptions);
  EXPECT_EQ(card.left_out, 7u);
  EXPECT_EQ(card.attacks, 43u);
  EXPECT_EQ(card.recorded, 100u);
}

TEST(Scorecard, IsTheSameForTheSameSeed) {
  std::mt19937_64 generator(6);
  const auto attacks = drawnWindows(12, 4, 0.3, generator);
  const auto recorded = drawnWindows(12, 15, 0.0, generator);
  const Scorecard one = scorecardOf(attacks, recorded, kOptions);
  const Scorecard same = scorecardOf(attacks, recorded, kOptions);
  EXPECT_EQ(accelerationRow(one).floor.wasserstein.mean,
            accelerationRow(same).floor.wasserstein.mean);
  EXPECT_EQ(one.classifiers.front().test.forest, same.classifiers.front().test.forest);
  EXPECT_EQ(one.classifiers.front().larger_floor.mean, same.classifiers.front().larger_floor.mean);
}

TEST(Scorecard, OfNothingHasNoRows) {
  const Scorecard card = scorecardOf({}, {}, kOptions);
  EXPECT_TRUE(card.distances.empty());
  EXPECT_TRUE(card.classifiers.empty());
}

}  // namespace
}  // namespace forge
