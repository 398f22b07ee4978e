#include "collision_forge/study/two_sample_classifier.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "study/test_windows.h"

namespace forge {
namespace {

const ClassifierOptions kOptions = shippedScorecardOptions().classifier;

/// `each` rows of five features in each of 40 scenes, each feature normal.
FeatureTable normalTable(int each, double mean, double deviation, std::mt19937_64& generator) {
  std::normal_distribution<double> normal(mean, deviation);
  FeatureTable table;
  table.features.resize(40 * each, 5);
  for (Eigen::Index row = 0; row < table.features.rows(); ++row) {
    for (Eigen::Index column = 0; column < 5; ++column) {
      table.features(row, column) = normal(generator);
    }
    table.scenes.push_back("scene-" + std::to_string(row / each));
  }
  return table;
}

Eigen::MatrixXd columnOf(const std::vector<double>& values) {
  return Eigen::VectorXd::Map(values.data(), static_cast<Eigen::Index>(values.size()));
}

TEST(AreaUnderCurve, CountsThePairsThatThePositiveWins) {
  // 3 beats 2 and 0; 1 beats 0; 2 beats 0 and ties with 2: 4.5 of 6.
  EXPECT_DOUBLE_EQ(areaUnderCurve({3.0, 1.0, 2.0}, {2.0, 0.0}), 4.5 / 6.0);
  EXPECT_EQ(areaUnderCurve({1.0}, {0.0}), 1.0);
  EXPECT_EQ(areaUnderCurve({0.0}, {1.0}), 0.0);
  EXPECT_EQ(areaUnderCurve({1.0, 1.0}, {1.0, 1.0, 1.0}), 0.5);
  EXPECT_THROW(areaUnderCurve({}, {1.0}), std::invalid_argument);
}

TEST(AreaStandardError, IsThatOverAllOrders) {
  // Which three of five places the positives take.
  double sum = 0.0, squares = 0.0;
  int orders = 0;
  for (int a = 0; a < 5; ++a) {
    for (int b = a + 1; b < 5; ++b) {
      std::vector<double> positives, negatives;
      for (int place = 0; place < 5; ++place) {
        (place == a || place == b ? negatives : positives).push_back(place);
      }
      const double area = areaUnderCurve(positives, negatives);
      sum += area;
      squares += area * area;
      ++orders;
    }
  }
  const double mean = sum / orders;
  EXPECT_NEAR(mean, 0.5, 1e-12);
  EXPECT_NEAR(areaStandardError(3, 2), std::sqrt(squares / orders - mean * mean), 1e-12);
}

TEST(LogisticRegression, FindsTheLogOddsOfTwoGroups) {
  // Of the left group one in four has the label, of the right one three.
  const Eigen::MatrixXd features = columnOf({-2, -2, -2, -2, 6, 6, 6, 6});
  Eigen::VectorXd labels(8);
  labels << 1, 0, 0, 0, 1, 1, 1, 0;
  const Eigen::VectorXd free = LogisticRegression(features, labels, 1e-9).scores(features);
  EXPECT_NEAR(free[0], -std::log(3.0), 1e-6);
  EXPECT_NEAR(free[7], std::log(3.0), 1e-6);
  // With a ridge the slope of the loss by the weight w is 8 p - 6 + ridge w, p = 1 / (1 + exp(-w)).
  const double ridge = 2.0;
  const double w = LogisticRegression(features, labels, ridge).scores(features)[7];
  EXPECT_NEAR(8.0 / (1.0 + std::exp(-w)) + ridge * w, 6.0, 1e-4);
}

TEST(LogisticRegression, StandsFeaturesThatDoNotVaryAndLabelsThatSeparate) {
  Eigen::MatrixXd features(6, 2);
  features << 0, 7, 1, 7, 2, 7, 10, 7, 11, 7, 12, 7;
  Eigen::VectorXd labels(6);
  labels << 0, 0, 0, 1, 1, 1;
  const Eigen::VectorXd scores = LogisticRegression(features, labels, 1e-3).scores(features);
  EXPECT_TRUE(scores.allFinite());
  EXPECT_LT(scores[2], 0.0);
  EXPECT_GT(scores[3], 0.0);
}

TEST(BoostedForest, TakesTheSecondOrderStepOfEachSide) {
  const Eigen::MatrixXd features = columnOf({0, 0, 0, 0, 1, 1, 1, 1});
  Eigen::VectorXd labels(8);
  labels << 1, 0, 0, 0, 1, 1, 1, 0;
  const ForestOptions one{1, 0.5, 1, 3.0};
  // Half of all have the label, so every row's gradient is +-1/2 and its curvature 1/4. Right:
  // gradient -1, curvature 1.
  const Eigen::VectorXd scores = BoostedForest(features, labels, one).scores(features);
  EXPECT_NEAR(scores[0], -0.5 * 1.0 / (1.0 + 3.0), 1e-12);
  EXPECT_NEAR(scores[7], 0.5 * 1.0 / (1.0 + 3.0), 1e-12);
}

TEST(BoostedForest, LeavesNoFewerRowsThanAllowed) {
  const Eigen::MatrixXd features = columnOf({0, 1, 2, 3, 4, 5});
  Eigen::VectorXd labels(6);
  labels << 0, 1, 1, 1, 1, 1;
  const ForestOptions three{1, 1.0, 3, 1.0};
  const Eigen::VectorXd scores = BoostedForest(features, labels, three).scores(features);
  EXPECT_EQ(scores[0], scores[2]);
  EXPECT_EQ(scores[3], scores[5]);
  EXPECT_LT(scores[0], scores[5]);
  const ForestOptions four{1, 1.0, 4, 1.0};
  const Eigen::VectorXd none = BoostedForest(features, labels, four).scores(features);
  EXPECT_EQ(none[0], none[5]);
}

TEST(BoostedForest, LearnsWhatTwoFeaturesTellTogether) {
  Eigen::MatrixXd features(40, 2);
  Eigen::VectorXd labels(40);
  for (Eigen::Index row = 0; row < 40; ++row) {
    features.row(row) << row % 2, row / 2 % 2;
    labels[row] = row % 4 == 3 ? 1.0 : 0.0;  // both 1
  }
  const Eigen::VectorXd scores = BoostedForest(features, labels, kOptions.forest).scores(features);
  for (Eigen::Index row = 0; row < 40; ++row) EXPECT_EQ(scores[row] > 0.0, labels[row] == 1.0);
}

TEST(TwoSampleTest, DrawsOfOneDistributionAreNotToldApart) {
  for (const std::uint64_t seed : {1u, 2u, 3u, 4u}) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937_64 generator(seed);
    const FeatureTable first = normalTable(5, 0.0, 1.0, generator);
    const FeatureTable second = normalTable(15, 0.0, 1.0, generator);
    const auto test = testTwoSamples(first, second, kOptions, seed);
    ASSERT_TRUE(test);
    EXPECT_EQ(test->first, 200u);
    EXPECT_EQ(test->second, 600u);
    EXPECT_NEAR(test->standard_error, areaStandardError(200, 600), 0.001);
    EXPECT_NEAR(test->logistic, 0.5, 3.0 * test->standard_error);
    EXPECT_NEAR(test->forest, 0.5, 3.0 * test->standard_error);
  }
}

TEST(TwoSampleTest, ShiftedDrawsAreToldApartByBoth) {
  // Five features one deviation apart: the best area is that of a shift of sqrt(5), .94.
  constexpr std::uint64_t kSeed = 5;
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  std::mt19937_64 generator(kSeed);
  const FeatureTable first = normalTable(10, 0.0, 1.0, generator);
  const FeatureTable second = normalTable(30, 1.0, 1.0, generator);
  const auto test = testTwoSamples(first, second, kOptions, kSeed);
  EXPECT_GT(test->logistic, 0.9);
  EXPECT_GT(test->forest, 0.9);
}

TEST(TwoSampleTest, WiderDrawsAreToldApartByTheForestAlone) {
  constexpr std::uint64_t kSeed = 6;
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  std::mt19937_64 generator(kSeed);
  const FeatureTable first = normalTable(10, 0.0, 3.0, generator);
  const FeatureTable second = normalTable(30, 0.0, 1.0, generator);
  const auto test = testTwoSamples(first, second, kOptions, kSeed);
  EXPECT_GT(test->forest, 0.9);
  EXPECT_LT(test->logistic, 0.65);
  EXPECT_EQ(test->larger(), test->forest);
}

TEST(TwoSampleTest, NoClassifierIsTestedOnAScene) {
  // Every scene has a number of its own, which tells its label to who has seen it.
  constexpr std::uint64_t kSeed = 7;
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  constexpr std::size_t kScenes = 100;  // of each sample
  constexpr Eigen::Index kEach = 20;
  std::mt19937_64 generator(kSeed);
  std::uniform_real_distribution<double> uniform;
  FeatureTable tables[2];
  for (int sample = 0; sample < 2; ++sample) {
    tables[sample].features.resize(kScenes * kEach, 1);
    for (Eigen::Index row = 0; row < tables[sample].features.rows(); ++row) {
      if (row % kEach == 0) tables[sample].features(row, 0) = uniform(generator);
      if (row % kEach != 0) tables[sample].features(row, 0) = tables[sample].features(row - 1, 0);
      tables[sample].scenes.push_back(std::to_string(sample) + "-" + std::to_string(row / kEach));
    }
  }
  const auto test = testTwoSamples(tables[0], tables[1], kOptions, kSeed);
  EXPECT_NEAR(test->forest, 0.5, 3.0 * areaStandardError(kScenes, kScenes));
}

TEST(TwoSampleTest, SameSeedSameAreas) {
  std::mt19937_64 generator(8);
  const FeatureTable first = normalTable(2, 0.0, 1.0, generator);
  const FeatureTable second = normalTable(2, 0.5, 1.0, generator);
  const auto one = testTwoSamples(first, second, kOptions, 1);
  const auto same = testTwoSamples(first, second, kOptions, 1);
  const auto other = testTwoSamples(first, second, kOptions, 2);
  EXPECT_EQ(one->logistic, same->logistic);
  EXPECT_EQ(one->forest, same->forest);
  EXPECT_NE(one->logistic, other->logistic);
}

TEST(TwoSampleTest, OneSceneCannotBeHalved) {
  FeatureTable table;
  table.features = Eigen::MatrixXd::Random(4, 2);
  table.scenes = {"a", "a", "a", "a"};
  EXPECT_FALSE(testTwoSamples(table, table, kOptions, 1));
}

}  // namespace
}  // namespace forge
