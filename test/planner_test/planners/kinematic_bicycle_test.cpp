#include "collision_forge/planner_test/planners/kinematic_bicycle.h"

#include <gtest/gtest.h>

#include <cmath>

#include "planner_test/planners/planner_scenes.h"

namespace forge {
namespace {

KinematicBicycleOptions withoutLags() {
  KinematicBicycleOptions options = shippedConfig().planners.car;
  options.acceleration_lag = 0.0;
  options.steering_lag = 0.0;
  return options;
}

BicycleState driven(const KinematicBicycle& bicycle, BicycleState state,
                    const BicycleCommand& command, int steps) {
  for (int i = 0; i < steps; ++i) state = bicycle.step(state, command, 0.1);
  return state;
}

TEST(KinematicBicycle, MovesAtTheSpeedAndHeadingBeforeTheStep) {
  const KinematicBicycle bicycle(withoutLags());
  const BicycleState end = driven(bicycle, {{3.0, 4.0, 0.5}, 5.0, 0.0, 0.0}, {2.0, 0.0}, 10);
  EXPECT_NEAR(end.speed, 7.0, 1e-12);
  const double way = 0.1 * (10 * 5.0 + 0.2 * (0 + 1 + 2 + 3 + 4 + 5 + 6 + 7 + 8 + 9));
  EXPECT_NEAR(end.rear_axle.x, 3.0 + way * std::cos(0.5), 1e-12);
  EXPECT_NEAR(end.rear_axle.y, 4.0 + way * std::sin(0.5), 1e-12);
}

TEST(KinematicBicycle, DrivesTheCircleOfItsSteering) {
  const KinematicBicycleOptions options = withoutLags();
  const KinematicBicycle bicycle(options);
  const double radius = 20.0;
  const double steering = std::atan(options.wheelbase / radius);
  const BicycleState start{{0.0, 0.0, 0.0}, 8.0, 0.0, steering};
  EXPECT_NEAR(bicycle.curvature(start), 1.0 / radius, 1e-12);
  const BicycleState end = driven(bicycle, start, {0.0, 0.0}, 30);
  const double turned = 24.0 / radius;
  EXPECT_NEAR(end.rear_axle.yaw, turned, 1e-9);
  // A chord of 0.8 m every step, each half a step's turn behind the circle's.
  EXPECT_NEAR(end.rear_axle.x, radius * std::sin(turned), 0.4);
  EXPECT_NEAR(end.rear_axle.y, radius * (1.0 - std::cos(turned)), 0.4);
}

TEST(KinematicBicycle, ARightTurnIsNegative) {
  const KinematicBicycle bicycle(withoutLags());
  const BicycleState end = driven(bicycle, {{}, 5.0, 0.0, 0.0}, {0.0, -0.2}, 10);
  EXPECT_NEAR(end.steering, -0.2, 1e-12);
  EXPECT_LT(bicycle.curvature(end), 0.0);
  EXPECT_LT(end.rear_axle.yaw, 0.0);
}

TEST(KinematicBicycle, BrakedOnAtAStandstillItRollsBack) {
  const KinematicBicycle bicycle(withoutLags());
  const BicycleState end = driven(bicycle, {{}, 0.2, 0.0, 0.0}, {-4.0, 0.0}, 2);
  EXPECT_NEAR(end.speed, -0.6, 1e-12);
  EXPECT_NEAR(end.rear_axle.x, 0.1 * (0.2 - 0.2), 1e-12);
}

TEST(KinematicBicycle, CommandsActWithTheirLags) {
  KinematicBicycleOptions options = withoutLags();
  options.acceleration_lag = 0.2;
  options.steering_lag = 0.05;
  const BicycleState end = KinematicBicycle(options).step({{}, 5.0, 0.0, 0.0}, {3.0, 0.3}, 0.1);
  EXPECT_NEAR(end.acceleration, 3.0 * 0.1 / 0.3, 1e-12);
  EXPECT_NEAR(end.steering, 0.03 * 0.1 / 0.15, 1e-12);
}

TEST(KinematicBicycle, KeepsItsLimits) {
  const KinematicBicycleOptions options = withoutLags();
  const KinematicBicycle bicycle(options);
  EXPECT_EQ(bicycle.step({{}, 20.0, 0.0, 0.0}, {-90.0, 0.0}, 0.1).acceleration,
            -options.max_braking);
  EXPECT_EQ(bicycle.step({{}, 20.0, 0.0, 0.0}, {90.0, 0.0}, 0.1).acceleration,
            options.max_acceleration);
  EXPECT_EQ(bicycle.step({{}, 2.0, 0.0, 0.0}, {0.0, 90.0}, 0.1).steering, options.max_steering);
  EXPECT_EQ(bicycle.step({{}, 2.0, 0.0, 0.0}, {0.0, -90.0}, 0.1).steering, -options.max_steering);
}

TEST(KinematicBicycle, PointsAndStatesAreTheSameMotion) {
  const KinematicBicycle bicycle(shippedConfig().planners.car);
  const BicycleState state{{3.0, 4.0, 0.5}, 5.0, -1.0, 0.2};
  const TrajectoryPoint point = bicycle.pointOf(state, 7.0, 1.385);
  EXPECT_EQ(point.time, 7.0);
  EXPECT_NEAR(point.pose.x, 3.0 + 1.385 * std::cos(0.5), 1e-12);
  EXPECT_NEAR(point.pose.y, 4.0 + 1.385 * std::sin(0.5), 1e-12);
  const BicycleState back = bicycle.stateOf(point, 1.385);
  EXPECT_NEAR(back.rear_axle.x, state.rear_axle.x, 1e-12);
  EXPECT_NEAR(back.rear_axle.y, state.rear_axle.y, 1e-12);
  EXPECT_EQ(back.rear_axle.yaw, state.rear_axle.yaw);
  EXPECT_EQ(back.speed, state.speed);
  EXPECT_EQ(back.acceleration, state.acceleration);
  EXPECT_NEAR(back.steering, state.steering, 1e-12);
}

}  // namespace
}  // namespace forge
