#include "collision_forge/study/evaluation/two_samples.h"

#include <gtest/gtest.h>

#include <random>

namespace forge {
namespace {

/// Pairs of normal features: of `first` with mean 0 and deviation 1, of `second` as given.
TwoSamples normalSamples(std::size_t pairs, double mean, double deviation) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  TwoSamples samples;
  for (std::size_t i = 0; i < pairs; ++i) {
    samples.first.push_back(Eigen::Vector3d(normal(random), normal(random), 4.0));
    samples.second.push_back(
        Eigen::Vector3d(mean + deviation * normal(random), normal(random), 4.0));
    samples.groups.push_back("vehicle " + std::to_string(i / 4));
  }
  return samples;
}

TEST(TwoSamples, TheAreaCountsPairsInOrderAndTiesHalf) {
  EXPECT_EQ(areaUnderCurve({1.0, 2.0}, {3.0, 4.0}), 1.0);
  EXPECT_EQ(areaUnderCurve({3.0, 4.0}, {1.0, 2.0}), 0.0);
  EXPECT_EQ(areaUnderCurve({1.0, 3.0}, {2.0, 3.0}), 2.5 / 4.0);
}

TEST(TwoSamples, EqualDistributionsHaveTheAreaOfChance) {
  const auto area = separate(normalSamples(400, 0.0, 1.0), 1);
  ASSERT_TRUE(area);
  EXPECT_NEAR(area->area, 0.5, 0.06);
  EXPECT_LE(area->area, area->chance_area + 0.02);
  EXPECT_NEAR(area->chance_area, 0.5, 0.08);
}

TEST(TwoSamples, AShiftOfTheMeanGivesTheAreaOfTwoNormals) {
  // Two normals of deviation 1 whose means differ by d: area = Phi(d / sqrt(2)).
  const double expected = 0.5 * std::erfc(-1.0 / 2.0);
  const TwoSamples samples = normalSamples(1000, 1.0, 1.0);
  const auto area = separate(samples, 1);
  ASSERT_TRUE(area);
  EXPECT_NEAR(area->area, expected, 0.05) << "five standard errors of samples of this size";
  std::vector<double> low;
  std::vector<double> high;
  for (const Eigen::VectorXd& features : samples.first) low.push_back(features[0]);
  for (const Eigen::VectorXd& features : samples.second) high.push_back(features[0]);
  EXPECT_NEAR(area->area, areaUnderCurve(low, high), 0.02) << "the best classifier";
  EXPECT_GT(area->area, area->chance_area);
}

TEST(TwoSamples, AnotherSpreadIsFoundToo) {
  EXPECT_GT(separate(normalSamples(400, 0.0, 4.0), 1)->area, 0.75);
}

TEST(TwoSamples, FewPairsOrOneGroupGiveNoArea) {
  EXPECT_FALSE(separate(normalSamples(19, 0.0, 1.0), 1));
  TwoSamples one = normalSamples(40, 0.0, 1.0);
  one.groups.assign(40, "the same vehicle");
  EXPECT_FALSE(separate(one, 1));
}

}  // namespace
}  // namespace forge
