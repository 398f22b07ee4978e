#include "planners/speed_plan.h"

#include <gtest/gtest.h>

namespace forge {
namespace {

TEST(SpeedPlan, SpreadsNumbersOverARange) {
  EXPECT_EQ(spread(1.0, 3.0, 5), (std::vector<double>{1.0, 1.5, 2.0, 2.5, 3.0}));
  EXPECT_EQ(spread(1.0, 3.0, 1), std::vector<double>{2.0});
}

TEST(SpeedPlan, PassesThroughTheMiddleSpeed) {
  const SpeedPlan plan = planThrough(10.0, 5.0, 7.0, 0.5, 10);
  ASSERT_EQ(plan.speeds.size(), 11U);
  EXPECT_NEAR(plan.speeds[0], 10.0, 1e-12);
  EXPECT_NEAR(plan.speeds[5], 5.0, 1e-12);
  EXPECT_NEAR(plan.speeds[10], 7.0, 1e-12);
  // The means of the halves times 2.5 s.
  EXPECT_NEAR(plan.distances[5], 7.5 * 2.5, 1e-12);
  EXPECT_NEAR(plan.distances[10], 7.5 * 2.5 + 6.0 * 2.5, 1e-12);
  EXPECT_NEAR(plan.accelerations[2], -2.0, 1e-12);
  EXPECT_NEAR(plan.accelerations[7], 0.8, 1e-12);
}

TEST(SpeedPlan, AnOddNumberOfStepsPassesTheMiddleBetweenTwo) {
  const SpeedPlan plan = planThrough(10.0, 5.0, 5.0, 0.2, 25);
  EXPECT_NEAR(plan.speeds[12], 10.0 - 2.0 * 2.4, 1e-12);
  EXPECT_NEAR(plan.speeds[13], 5.0, 1e-12);
  EXPECT_NEAR(plan.distances[13], 7.5 * 2.5 + 5.0 * 0.1, 1e-12);
}

TEST(SpeedPlan, TakesOnATargetSpeedAndKeepsIt) {
  const SpeedPlan braking = planTowards(8.0, 4.0, 2.0, 1.0, 4);
  EXPECT_EQ(braking.speeds, (std::vector<double>{8.0, 6.0, 4.0, 4.0, 4.0}));
  EXPECT_EQ(braking.distances, (std::vector<double>{0.0, 7.0, 12.0, 16.0, 20.0}));
  EXPECT_EQ(braking.accelerations, (std::vector<double>{-2.0, -2.0, 0.0, 0.0, 0.0}));
  EXPECT_EQ(planTowards(3.0, 5.0, 1.0, 1.0, 3).speeds, (std::vector<double>{3.0, 4.0, 5.0, 5.0}));
  EXPECT_EQ(planTowards(3.0, 3.0, 1.0, 1.0, 2).distances, (std::vector<double>{0.0, 3.0, 6.0}));
}

}  // namespace
}  // namespace forge
