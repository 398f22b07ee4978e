#include "collision_forge/attack/verify/post_crash_motion.h"

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

CrashedVehicle car(const Pose2& pose, const Vector2& velocity) {
  return {AgentClass::kCar, kCarSize, {10.0, pose, velocity}};
}

TEST(PostCrashMotion, KeepsTheMomentumOfTwoEqualBoxes) {
  const PostCrashMotion motion(car({}, {10.0, 0.0}), car({}, {0.0, 6.0}), limits());
  EXPECT_EQ(motion.contactTime(), 10.0);
  EXPECT_NEAR((motion.egoAt(10.0).velocity - Vector2(5.0, 3.0)).norm(), 0.0, 1e-9);
  EXPECT_NEAR((motion.attackerAt(10.0).velocity - Vector2(5.0, 3.0)).norm(), 0.0, 1e-9);
}

TEST(PostCrashMotion, UsesBoxAreaAsMassAndTheWeakerBrakes) {
  const BoxSize long_bus{3.0 * kCarSize.length, kCarSize.width};
  const CrashedVehicle bus{AgentClass::kBus, long_bus, {10.0, {}, {-8.0, 0.0}}};
  const PostCrashMotion motion(car({}, {10.0, 0.0}), bus, limits());
  const double speed = 0.75 * 8.0 - 0.25 * 10.0;
  EXPECT_NEAR(motion.egoAt(10.0).velocity.x(), -speed, 1e-9);
  const double braking = brakingOf(AgentClass::kBus, long_bus);
  EXPECT_LT(braking, brakingOf(AgentClass::kCar, kCarSize));
  EXPECT_NEAR(motion.standTime(), 10.0 + speed / braking, 1e-9);
}

TEST(PostCrashMotion, BothKeepTheirRelativePoseUntilTheyStand) {
  const Pose2 ego{1.0, 2.0, 0.3};
  const Pose2 attacker{4.0, 3.0, 2.0};
  const PostCrashMotion motion(car(ego, {6.0, 0.0}), car(attacker, {0.0, 2.0}), limits());
  const Pose2 offset = relativeTo(ego, attacker);
  for (const double time : {9.0, 10.0, 10.2, 11.0, 60.0}) {
    const Pose2 now = relativeTo(motion.egoAt(time).pose, motion.attackerAt(time).pose);
    EXPECT_NEAR((now.position() - offset.position()).norm(), 0.0, 1e-9) << time;
    EXPECT_NEAR(now.yaw, offset.yaw, 1e-9) << time;
    EXPECT_EQ(motion.egoAt(time).time, time);
  }
  EXPECT_EQ(motion.egoAt(9.0).pose.x, ego.x) << "before the contact as at the contact";
  EXPECT_GT(motion.egoAt(10.2).pose.x, ego.x);
  EXPECT_NEAR(motion.egoAt(motion.standTime()).velocity.norm(), 0.0, 1e-9);
  EXPECT_NEAR(motion.egoAt(motion.standTime()).pose.x, motion.egoAt(60.0).pose.x, 1e-9);
}

/// From kNow on for two seconds along +y.
AttackerTrajectory straight() {
  AttackerTrajectory trajectory{"attacker", AgentClass::kCar, kCarSize, {}};
  for (int i = 0; i <= 20; ++i) {
    trajectory.points.push_back({kNow + 0.1 * i, {0.0, 0.6 * i, M_PI / 2}, 6.0, 0.0, 0.0});
  }
  return trajectory;
}

/// Along +x at 10 m/s, over the same time.
Track drivingEgo() {
  Track ego{kEgoId, AgentClass::kCar, kCarSize, {}};
  for (int i = 0; i <= 4; ++i) {
    ego.states.push_back({kNow + 0.5 * i, {5.0 * i, 0.0, 0.0}, {10.0, 0.0}});
  }
  return ego;
}

TEST(MotionAfterContact, BeginsWithTheStatesOfTrajectoryAndEgo) {
  const auto motion = motionAfterContact(kNow + 1.25, straight(), drivingEgo(), limits());
  ASSERT_TRUE(motion);
  EXPECT_EQ(motion->contactTime(), kNow + 1.25);
  EXPECT_NEAR(motion->egoAt(kNow + 1.25).pose.x, 12.5, 1e-9);
  EXPECT_NEAR(motion->attackerAt(kNow + 1.25).pose.y, 7.5, 1e-9);
  EXPECT_NEAR((motion->egoAt(kNow + 1.25).velocity - Vector2(5.0, 3.0)).norm(), 0.0, 1e-9);
}

TEST(MotionAfterContact, ATimeRoundedBeyondTheEndIsTheEnd) {
  EXPECT_TRUE(motionAfterContact(kNow + 2.0 + 4e-7, straight(), drivingEgo(), limits()));
}

TEST(MotionAfterContact, IsEmptyWithoutAContactOrWithoutAnEgoState) {
  EXPECT_FALSE(motionAfterContact(kNow + 2.5, straight(), drivingEgo(), limits()));
  EXPECT_FALSE(motionAfterContact(kNow + 1.0, straight(), {}, limits()));
  CollisionReport report;
  report.contact_time = kNow + 1.0;
  EXPECT_FALSE(motionAfterContact(report, straight(), drivingEgo(), limits()));
  report.contact = true;
  EXPECT_TRUE(motionAfterContact(report, straight(), drivingEgo(), limits()));
}

}  // namespace
}  // namespace forge
