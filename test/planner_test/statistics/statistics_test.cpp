#include "collision_forge/planner_test/statistics/statistics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace forge {
namespace {

const StatisticsOptions kOptions{4000, 0.95, 7};

Trial trial(const std::string& scene, bool success, double tta = 1.0,
            CollisionType type = CollisionType::kRearEnd) {
  return {scene, type, tta, success ? 1.0 : 0.0};
}

/// Creates `scenes` scenes with `each` trials; all trials of a scene succeed or fail together.
std::vector<Trial> clustered(int scenes, int each) {
  std::vector<Trial> trials;
  for (int i = 0; i < scenes * each; ++i) {
    const int scene = i / each;
    trials.push_back(trial("scene-" + std::to_string(scene), scene % 2 == 0));
  }
  return trials;
}

TEST(Statistics, RateIsPooledOverTrialsNotOverScenes) {
  const Rate rate = pooledRate(
      {trial("a", true), trial("a", true), trial("a", true), trial("b", false)}, kOptions);
  EXPECT_EQ(rate.trials, 4);
  EXPECT_EQ(rate.value, 0.75);
}

TEST(Statistics, RateOfOtherValuesIsTheirMeanWithItsInterval) {
  std::vector<Trial> trials;
  for (const double value : {-0.5, 0.0, 0.25, 0.5, 1.0}) {
    trials.push_back({"scene " + std::to_string(value), CollisionType::kRearEnd, 1.0, value});
  }
  const Rate rate = pooledRate(trials, kOptions);
  EXPECT_DOUBLE_EQ(rate.value, 0.25);
  EXPECT_LT(rate.interval->low, 0.25);
  EXPECT_GT(rate.interval->low, -0.5);
  EXPECT_GT(rate.interval->high, 0.25);
  EXPECT_LT(rate.interval->high, 1.0);
}

TEST(Statistics, EqualScenesLeaveNoInterval) {
  std::vector<Trial> trials;
  for (const char* scene : {"a", "b", "c", "d", "e"}) {
    trials.push_back(trial(scene, true));
    trials.push_back(trial(scene, false));
  }
  const Rate rate = pooledRate(trials, kOptions);
  EXPECT_EQ(rate.interval->low, 0.5);
  EXPECT_EQ(rate.interval->high, 0.5);
}

TEST(Statistics, FewerThanFiveScenesHaveNoInterval) {
  for (int scenes = 1; scenes < 5; ++scenes) {
    const Rate rate = pooledRate(clustered(scenes, 10), kOptions);
    EXPECT_EQ(rate.trials, 10 * scenes);
    EXPECT_FALSE(rate.interval.has_value()) << scenes;
  }
  EXPECT_TRUE(pooledRate(clustered(5, 10), kOptions).interval.has_value());
}

TEST(Statistics, IntervalMatchesIndependentlyDrawnScenes) {
  // 100 scenes, half of them 1 and half 0: the rate's standard deviation is sqrt(0.25 / 100).
  const Rate rate = pooledRate(clustered(100, 1), kOptions);
  EXPECT_NEAR(rate.interval->low, 0.5 - 1.96 * 0.05, 0.012);
  EXPECT_NEAR(rate.interval->high, 0.5 + 1.96 * 0.05, 0.012);
}

TEST(Statistics, TrialsOfOneSceneDoNotNarrowTheInterval) {
  const Rate one = pooledRate(clustered(100, 1), kOptions);
  const Rate ten = pooledRate(clustered(100, 10), kOptions);
  EXPECT_EQ(ten.trials, 1000);
  EXPECT_EQ(ten.interval->low, one.interval->low);
  EXPECT_EQ(ten.interval->high, one.interval->high);
}

TEST(Statistics, DependsOnTheSeedButNotOnTheOrderOfTrials) {
  std::vector<Trial> trials = clustered(37, 3);
  const Rate rate = pooledRate(trials, kOptions);
  std::shuffle(trials.begin(), trials.end(), std::mt19937_64(5));
  const Rate shuffled = pooledRate(trials, kOptions);
  EXPECT_EQ(rate.interval->low, shuffled.interval->low);
  EXPECT_EQ(rate.interval->high, shuffled.interval->high);
  bool differs = false;
  for (const std::uint64_t seed : {8u, 9u, 10u, 11u}) {
    const Rate other = pooledRate(trials, {40, 0.95, seed});
    differs = differs || other.interval->low != pooledRate(trials, {40, 0.95, 7}).interval->low;
  }
  EXPECT_TRUE(differs);
}

TEST(Statistics, GroupsAreTypesThenTtasThenAll) {
  const std::vector<Trial> trials = {
      trial("a", true, 0.5, CollisionType::kLaneChange),
      trial("b", true, 1.5, CollisionType::kOppositeDirection),
      trial("c", true, 4.5, CollisionType::kLtap),
      trial("d", true, 6.5, CollisionType::kLtap),
      trial("e", true, 8.0, CollisionType::kJunctionCrossing),
  };
  const auto groups = groupTrials(trials);
  const std::vector<std::pair<std::string, std::size_t>> expected = {
      {"LC", 1},      {"OD", 1},        {"RE", 0},      {"JC", 1},      {"LTAP", 2},
      {"0.5-1 s", 1}, {"1.5-2.5 s", 1}, {"3-4.5 s", 1}, {"5-6.5 s", 1}, {"all", 5}};
  ASSERT_EQ(groups.size(), expected.size());
  for (std::size_t i = 0; i < groups.size(); ++i) {
    EXPECT_EQ(groups[i].title, expected[i].first);
    EXPECT_EQ(groups[i].trials.size(), expected[i].second) << groups[i].title;
  }
}

TEST(Statistics, EveryTtaOfTheSetFallsIntoItsBucket) {
  const auto bucketOf = [](double tta) -> std::string {
    const auto groups = groupTrials({trial("a", true, tta)});
    for (std::size_t i = 5; i < 9; ++i) {
      if (!groups[i].trials.empty()) return groups[i].title;
    }
    return "none";
  };
  for (const double tta : {0.5, 1.0, 1.25}) EXPECT_EQ(bucketOf(tta), "0.5-1 s") << tta;
  for (const double tta : {1.3, 1.5, 2.0, 2.5}) EXPECT_EQ(bucketOf(tta), "1.5-2.5 s") << tta;
  for (const double tta : {2.8, 3.0, 3.5, 4.0, 4.5}) EXPECT_EQ(bucketOf(tta), "3-4.5 s") << tta;
  for (const double tta : {5.0, 5.5, 6.0, 6.5, 7.0}) EXPECT_EQ(bucketOf(tta), "5-6.5 s") << tta;
  EXPECT_EQ(bucketOf(7.5), "none");
}

}  // namespace
}  // namespace forge
