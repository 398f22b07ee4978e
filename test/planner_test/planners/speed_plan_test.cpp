#include "collision_forge/planner_test/planners/speed_plan.h"

#include <gtest/gtest.h>

#include "planner_test/planners/planner_scenes.h"

namespace forge {
namespace {

const RuleBasedOptions& options() { return shippedConfig().planners.rule_based; }

TEST(SpeedPlan, SpreadsNumbersOverARange) {
  EXPECT_EQ(spread(1.0, 3.0, 5), (std::vector<double>{1.0, 1.5, 2.0, 2.5, 3.0}));
  EXPECT_EQ(spread(3.0, 1.0, 3), (std::vector<double>{3.0, 2.0, 1.0}));
  EXPECT_EQ(spread(1.0, 3.0, 1), std::vector<double>{2.0});
}

TEST(SpeedPlan, TakesOnATargetSpeedAndKeepsIt) {
  const SpeedPlan braking = planTowards(8.0, 4.0, 2.0, 1.0, 4);
  EXPECT_EQ(braking.speeds, (std::vector<double>{8.0, 6.0, 4.0, 4.0, 4.0}));
  EXPECT_EQ(braking.distances, (std::vector<double>{0.0, 6.0, 10.0, 14.0, 18.0}));
  EXPECT_EQ(planTowards(3.0, 4.5, 1.0, 1.0, 3).speeds, (std::vector<double>{3.0, 4.0, 4.5, 4.5}));
}

TEST(SpeedPlan, ReversesWithNegativeSpeeds) {
  const SpeedPlan plan = planTowards(-2.0, -1.0, 0.5, 1.0, 3);
  EXPECT_EQ(plan.speeds, (std::vector<double>{-2.0, -1.5, -1.0, -1.0}));
  EXPECT_EQ(plan.distances, (std::vector<double>{0.0, -1.5, -2.5, -3.5}));
}

TEST(SpeedProfiles, EveryEndFollowsEveryMiddle) {
  const std::vector<SpeedProfile> profiles = speedProfiles(7.5, options());
  ASSERT_EQ(profiles.size(), 25U);
  // 12 steps of 0.2 s at 3 m/s2 change the speed by 7.2, 13 by 7.8.
  EXPECT_NEAR(profiles.front().middle_speed, 0.3, 1e-12);
  EXPECT_NEAR(profiles.front().end_speed, 0.0, 1e-12);
  EXPECT_NEAR(profiles.back().middle_speed, 14.7, 1e-12);
  EXPECT_NEAR(profiles.back().end_speed, 15.0, 1e-12);
  EXPECT_EQ(profiles[3].middle_speed, profiles[4].middle_speed);
  for (const SpeedProfile& profile : profiles) {
    ASSERT_EQ(profile.plan.speeds.size(), 26U);
    EXPECT_NEAR(profile.plan.speeds[12], profile.middle_speed, 1e-12);
    EXPECT_NEAR(profile.plan.speeds[25], profile.end_speed, 1e-12);
  }
}

TEST(SpeedProfiles, TooFastTargetsDescendToTheGreatestSpeed) {
  const std::vector<SpeedProfile> profiles = speedProfiles(24.0, options());
  EXPECT_NEAR(profiles.front().middle_speed, 24.0 - 7.2, 1e-12);
  EXPECT_NEAR(profiles.back().middle_speed, 15.0, 1e-12);
  // Braking as hard as it may it does not get there.
  EXPECT_NEAR(profiles.back().plan.speeds[12], 24.0 - 7.2, 1e-12);
}

}  // namespace
}  // namespace forge
