#include "collision_forge/study/evaluation/calibration.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace forge {
namespace {

/// `count` predictions with confidence 0, 1 / count, ...; the highest `kept` of them succeed.
std::vector<Prediction> ladder(int count, int kept) {
  std::vector<Prediction> promises;
  for (int i = 0; i < count; ++i) {
    const double value = i >= count - kept ? 1.0 : 0.0;
    promises.push_back({static_cast<double>(i) / count,
                        {"scene-" + std::to_string(i), CollisionType::kRearEnd, 2.0, value}});
  }
  return promises;
}

TEST(Calibration, DecilesHaveEqualSizesAndAreSorted) {
  std::vector<Prediction> promises = ladder(200, 70);
  std::reverse(promises.begin(), promises.end());
  const Calibration calibration = calibrate("angle bands", promises);
  ASSERT_EQ(calibration.deciles.size(), 10u);
  for (int decile = 0; decile < 10; ++decile) {
    const CalibrationGroup& group = calibration.deciles[static_cast<std::size_t>(decile)];
    EXPECT_EQ(group.kept.trials, 20);
    EXPECT_NEAR(group.mean_confidence, (20.0 * decile + 9.5) / 200.0, 1e-12);
    const double expected = decile < 6 ? 0.0 : decile == 6 ? 0.5 : 1.0;
    EXPECT_EQ(group.kept.value, expected);
    EXPECT_NEAR(group.difference(), expected - group.mean_confidence, 1e-12);
  }
}

TEST(Calibration, LargestDifferenceIgnoresTheSign) {
  // No prediction succeeds, so the last decile has the largest difference.
  const Calibration none = calibrate("", ladder(100, 0));
  EXPECT_NEAR(none.largestDifference(), 0.945, 1e-12);
  const Calibration all = calibrate("", ladder(100, 100));
  EXPECT_NEAR(all.largestDifference(), 1.0 - 0.045, 1e-12);
}

TEST(Calibration, FewPromisesGiveNoEmptyGroups) {
  EXPECT_TRUE(calibrate("", {}).deciles.empty());
  EXPECT_EQ(calibrate("", {}).largestDifference(), 0.0);
  const Calibration three = calibrate("", ladder(3, 1));
  ASSERT_EQ(three.deciles.size(), 3u);
  EXPECT_EQ(three.deciles[2].kept.value, 1.0);
  int trials = 0;
  for (const CalibrationGroup& group : calibrate("", ladder(37, 1)).deciles) {
    EXPECT_TRUE(group.kept.trials == 3 || group.kept.trials == 4);
    trials += group.kept.trials;
  }
  EXPECT_EQ(trials, 37);
}

TEST(Calibration, MarkdownHasPercentAndTheLargestDifference) {
  const Calibration calibration{
      "angle bands",
      {{0.25, {40, 0.2, Interval{0.1, 0.304}}}, {0.75, {40, 0.875, Interval{0.8, 0.9}}}}};
  EXPECT_EQ(toMarkdown(calibration),
            "Calibration, angle bands, %\n\n| decile | attacks | mean confidence | happened | "
            "difference |\n"
            "|---|---|---|---|---|\n"
            "| 1 | 40 | 25.0 | 20.0 [10, 30] | -5.0 |\n"
            "| 2 | 40 | 75.0 | 87.5 [80, 90] | +12.5 |\n"
            "\nLargest difference: 12.5 points\n");
}

}  // namespace
}  // namespace forge
