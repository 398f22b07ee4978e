#include "collision_forge/planner_test/planners/pdm_brake.h"

#include <gtest/gtest.h>

#include "planner_test/planners/planner_scenes.h"

namespace forge {
namespace {

const PdmBrakeOptions& brakeOptions() { return shippedConfig().planners.pdm.emergency_brake; }

TEST(PdmBrake, FiresForANearCollisionOfASlowEgo) {
  const PdmBrakeOptions& options = brakeOptions();
  EXPECT_TRUE(firesBrake(options.max_speed, options.max_time, options));
  EXPECT_FALSE(firesBrake(options.max_speed + 0.01, options.max_time, options));
  EXPECT_FALSE(firesBrake(options.max_speed, options.max_time + 0.1, options));
  EXPECT_FALSE(firesBrake(1.0, std::nullopt, options));
}

TEST(PdmBrake, LaysOutBehindASlowEgoAndAheadOfAFasterOne) {
  const PdmBrakeOptions& options = brakeOptions();
  EXPECT_LT(brakeSpeed(2.0, 0.0, options), 0.0);
  EXPECT_NEAR(brakeSpeed(5.0, 0.0, options), options.overshoot * (5.0 - options.braking), 1e-12);
  EXPECT_GT(brakeSpeed(0.0, -1.0, options), 0.0);
  EXPECT_NEAR(brakeSpeed(0.0, -9.0, options), options.max_acceleration, 1e-12);
}

TEST(PdmBrake, PosesAreOnAStraightLine) {
  const std::vector<Pose2> poses = brakePoses({1.0, 2.0, 0.5 * M_PI}, -2.0, 80, 0.1);
  ASSERT_EQ(poses.size(), 81U);
  EXPECT_NEAR(poses[10].y, 0.0, 1e-12);
  EXPECT_NEAR(poses[10].x, 1.0, 1e-12);
}

TEST(PdmBrake, TurningAddsToTheAccelerationOfTheMiddle) {
  // 4 m/s on a curvature of 0.25: 1 rad/s.
  EXPECT_NEAR(centerAcceleration({{}, 4.0, -1.0, 0.0}, 0.25, 1.5), 0.5, 1e-12);
}

}  // namespace
}  // namespace forge
