#include "collision_forge/attack/verify/contact_watch.h"

#include <gtest/gtest.h>

#include "collision_forge/planner_test/settings/config.h"

namespace forge {
namespace {

constexpr double kNow = 10.0;  // s
constexpr BoxSize kSize{4.0, 2.0};

const VerificationOptions& options() {
  static const Config config = loadConfig(COLLISION_FORGE_SOURCE_DIR "/config");
  return config.attack.verification;
}

/// From x = 0 along x at 10 m/s, for 2 s.
AttackerTrajectory trajectory() {
  AttackerTrajectory trajectory{"a", AgentClass::kCar, kSize, {}};
  for (int i = 0; i <= 20; ++i) {
    trajectory.points.push_back({kNow + 0.1 * i, {1.0 * i, 0.0, 0.0}, 10.0, 0.0, 0.0});
  }
  return trajectory;
}

/// Ahead of the attacker, from x = 10 at now at 4 m/s: the boxes touch 1 s later.
AgentState ego(double time) { return {time, {10.0 + 4.0 * (time - kNow), 0.0, 0.0}}; }

class ContactWatchTest : public testing::Test {
 protected:
  void drive(double from, double to) {
    for (int i = 0; from + 0.05 * i <= to + 1e-6; ++i) watch_.addEgo(ego(from + 0.05 * i));
  }

  ContactWatch watch_{kSize, 60.0, options()};
};

TEST_F(ContactWatchTest, TheCrashIsKnownWithTheFirstPoseAfterTheContact) {
  watch_.start(trajectory());
  drive(9.5, 10.98);
  EXPECT_FALSE(watch_.crash());
  watch_.addEgo(ego(11.03));
  ASSERT_TRUE(watch_.crash());
  EXPECT_NEAR(watch_.crash()->contactTime(), 11.0, 1e-2);
  EXPECT_NEAR(watch_.crash()->egoAt(11.0).velocity.x(), 4.0, 1e-3);
  EXPECT_GT(watch_.crash()->egoAt(11.1).velocity.x(), 6.0) << "pushed by an equal car at 10 m/s";
}

TEST_F(ContactWatchTest, TheVelocityAtTheContactMatchesTheWholeRecording) {
  Track whole{kEgoId, AgentClass::kCar, kSize, {}};
  watch_.start(trajectory());
  for (int i = 0; i <= 40; ++i) {  // brakes with 4 m/s2
    const double time = 0.05 * i;
    const AgentState state{kNow + time, {12.0 + 8.0 * time - 2.0 * time * time, 0.0, 0.0}};
    whole.states.push_back(state);
    watch_.addEgo(state);
  }
  deriveVelocities(whole);
  ASSERT_TRUE(watch_.crash());
  const double contact = watch_.crash()->contactTime();
  const auto expected = motionAfterContact(contact, trajectory(), whole, options().severity);
  EXPECT_DOUBLE_EQ(watch_.crash()->egoAt(20.0).pose.x, expected->egoAt(20.0).pose.x);
}

TEST_F(ContactWatchTest, AContactBeforeTheAttackIsStartedIsFound) {
  drive(9.5, 11.5);
  EXPECT_FALSE(watch_.crash());
  watch_.start(trajectory());
  ASSERT_TRUE(watch_.crash());
  EXPECT_NEAR(watch_.crash()->contactTime(), 11.0, 1e-2);
}

TEST_F(ContactWatchTest, ANewPlanKeepsTheContactAndAnotherAttackForgetsIt) {
  watch_.start(trajectory());
  drive(9.5, 11.5);
  AttackerTrajectory away = trajectory();
  for (TrajectoryPoint& point : away.points) point.pose.y = 50.0;
  watch_.change(away);
  EXPECT_TRUE(watch_.crash());
  watch_.start(away);
  EXPECT_FALSE(watch_.crash());
  watch_.start(trajectory());
  EXPECT_TRUE(watch_.crash());
  watch_.stop();
  EXPECT_FALSE(watch_.crash());
}

TEST_F(ContactWatchTest, AReplayThatGoesBackToBeforeTheContactForgetsIt) {
  watch_.start(trajectory());
  drive(9.5, 12.0);
  drive(11.5, 11.6);
  EXPECT_TRUE(watch_.crash()) << "after the contact";
  drive(9.5, 10.5);
  EXPECT_FALSE(watch_.crash());
  drive(10.55, 11.5);
  EXPECT_TRUE(watch_.crash());
}

}  // namespace
}  // namespace forge
