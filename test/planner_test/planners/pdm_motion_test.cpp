#include "collision_forge/planner_test/planners/pdm_motion.h"

#include <gtest/gtest.h>

#include "planner_test/planners/planner_scenes.h"

namespace forge {
namespace {

const EgoVehicle kEgo{{4.0, 1.8}, 1.5};

TEST(PdmMotion, FollowsPosesFromWhereTheCarIs) {
  const PlannerOptions& options = shippedConfig().planners;
  const KinematicBicycle bicycle(options.car);
  LqrTracker tracker(options.lqr, options.car.wheelbase);
  std::vector<Pose2> poses;
  for (int i = 0; i <= 80; ++i) poses.push_back({0.8 * i, 0.0, 0.0});
  const BicycleState start{{0.0, 0.5, 0.0}, 8.0, 0.0, 0.0};
  const PdmMotion motion = simulate(start, poses, bicycle, tracker, 0.1, kEgo);
  ASSERT_EQ(motion.states.size(), 81U);
  ASSERT_EQ(motion.boxes.size(), 81U);
  EXPECT_EQ(motion.states.front().rear_axle.y, 0.5);
  EXPECT_NEAR(motion.states.back().rear_axle.x, 64.0, 0.5);
  EXPECT_NEAR(motion.states.back().rear_axle.y, 0.0, 0.05);
}

TEST(PdmMotion, BoxesAreAheadOfTheRearAxle) {
  const PdmMotion motion = motionOf({{{0.0, 0.0, 0.5 * M_PI}, 5.0, 0.0, 0.0}}, kEgo);
  ASSERT_EQ(motion.boxes.size(), 1U);
  EXPECT_NEAR(motion.boxes[0].center.y, 1.5, 1e-12);
  EXPECT_EQ(motion.boxes[0].size.length, 4.0);
}

}  // namespace
}  // namespace forge
