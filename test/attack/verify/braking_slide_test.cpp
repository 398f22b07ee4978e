#include "collision_forge/attack/verify/braking_slide.h"

#include <gtest/gtest.h>

#include <cmath>

#include "attack/search/test_scenes.h"
#include "collision_forge/planner_test/settings/config.h"

namespace forge {
namespace {

const DriveLimitOptions& limits() {
  static const Config config = loadConfig(COLLISION_FORGE_SOURCE_DIR "/config");
  return config.attack.verification.drivable;
}

double brakingOf(AgentClass agent_class, const BoxSize& size) {
  return driveLimitsOf(agent_class, size, limits()).max_braking;
}

/// From kNow on for two seconds, straight from the origin.
AttackerTrajectory straight(double speed, double yaw, AgentClass agent_class, BoxSize size) {
  AttackerTrajectory trajectory{"attacker", agent_class, size, {}};
  for (int i = 0; i <= 20; ++i) {
    const double way = 0.1 * i * speed;
    const Pose2 pose{way * std::cos(yaw), way * std::sin(yaw), yaw};
    trajectory.points.push_back({kNow + 0.1 * i, pose, speed, 0.0, 0.0});
  }
  return trajectory;
}

TEST(BrakingSlide, DeceleratesConstantlyUntilItStands) {
  const BrakingSlide slide{10.0, {0.0, 6.0}, 4.0};  // stands after 1.5 s and 6 * 1.5 / 2 m
  const Pose2 start{1.0, 2.0, 0.3};
  EXPECT_EQ(slide.stateFrom(start, 10.0).pose.y, 2.0);
  EXPECT_EQ(slide.stateFrom(start, 10.0).velocity, Vector2(0.0, 6.0));
  // Against a sum of many small steps.
  double y = 2.0;
  double speed = 6.0;
  constexpr double kStep = 1e-5;  // s
  for (double time = 0.0; time < 1.0; time += kStep) {
    y += speed * kStep;
    speed -= 4.0 * kStep;
  }
  EXPECT_NEAR(slide.stateFrom(start, 11.0).pose.y, y, 1e-3);
  EXPECT_NEAR(slide.stateFrom(start, 11.0).velocity.y(), speed, 1e-3);
  for (const double time : {11.5, 12.0, 100.0}) {
    const AgentState state = slide.stateFrom(start, time);
    EXPECT_EQ(state.time, time);
    EXPECT_NEAR(state.pose.y, 2.0 + 4.5, 1e-9);
    EXPECT_EQ(state.pose.x, 1.0);
    EXPECT_EQ(state.pose.yaw, 0.3);
    EXPECT_NEAR(state.velocity.norm(), 0.0, 1e-9);
  }
  EXPECT_DOUBLE_EQ(slide.standTime(), 11.5);
}

TEST(BrakingSlide, StandingVehicleStays) {
  const AgentState state = BrakingSlide{10.0, {0.0, 0.0}, 4.0}.stateFrom({1.0, 2.0, 0.3}, 20.0);
  EXPECT_EQ(state.pose.position(), Vector2(1.0, 2.0));
  EXPECT_EQ(state.velocity, Vector2(0.0, 0.0));
  EXPECT_EQ((BrakingSlide{10.0, {0.0, 0.0}, 4.0}.standTime()), 10.0);
}

TEST(SlideFromEnd, IsStraightOnAsHardAsTheClassBrakes) {
  const BoxSize bus{12.0, 2.9};
  const BrakingSlide slide = slideFromEnd(straight(8.0, M_PI / 2, AgentClass::kBus, bus), limits());
  EXPECT_DOUBLE_EQ(slide.begin, kNow + 2.0);
  EXPECT_NEAR((slide.velocity - Vector2(0.0, 8.0)).norm(), 0.0, 1e-9);
  EXPECT_EQ(slide.braking, brakingOf(AgentClass::kBus, bus));
  EXPECT_LT(slide.braking, brakingOf(AgentClass::kCar, kCarSize));
}

}  // namespace
}  // namespace forge
