#include "collision_forge/planners/speed_plan.h"

#include <gtest/gtest.h>

namespace forge {
namespace {

TEST(SpeedPlan, SpreadsNumbersOverARange) {
  EXPECT_EQ(spread(1.0, 3.0, 5), (std::vector<double>{1.0, 1.5, 2.0, 2.5, 3.0}));
  EXPECT_EQ(spread(1.0, 3.0, 1), std::vector<double>{2.0});
}

TEST(SpeedPlan, HoldsTheMiddleSpeedUntilHalfOfTheTime) {
  // Braking for 2 s, held for 0.5 s, accelerating for 1 s, held for 1.5 s.
  const SpeedPlan plan = planThrough(10.0, 5.0, 7.5, 2.5, 0.5, 10);
  EXPECT_EQ(plan.speeds,
            (std::vector<double>{10.0, 8.75, 7.5, 6.25, 5.0, 5.0, 6.25, 7.5, 7.5, 7.5, 7.5}));
  EXPECT_EQ(plan.accelerations,
            (std::vector<double>{-2.5, -2.5, -2.5, -2.5, 0.0, 2.5, 2.5, 0.0, 0.0, 0.0, 0.0}));
  EXPECT_NEAR(plan.distances[5], 15.0 + 2.5, 1e-12);
  EXPECT_NEAR(plan.distances[10], 15.0 + 2.5 + 6.25 + 1.5 * 7.5, 1e-12);
}

TEST(SpeedPlan, StretchesMayEndBetweenSteps) {
  const SpeedPlan plan = planThrough(10.0, 5.0, 5.0, 2.0, 0.2, 25);
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
