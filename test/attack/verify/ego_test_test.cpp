#include "collision_forge/attack/verify/ego_test.h"

#include <gtest/gtest.h>

#include <cmath>

#include "attack/search/test_scenes.h"

namespace forge {
namespace {

constexpr double kSpeed = 10.0;  // m/s, of the attacker along +x

/// Ten metres per second along +x for three seconds, a point every 0.1 s.
AttackerTrajectory straightAttack() {
  AttackerTrajectory trajectory{"attacker", AgentClass::kCar, kCarSize, {}};
  for (int i = 0; i <= 30; ++i) {
    const double t = 0.1 * i;
    trajectory.points.push_back({kNow + t, {kSpeed * t, 0.0, 0.0}, kSpeed, 0.0, 0.0});
  }
  return trajectory;
}

CollisionRequest rearEnd(double tta) { return requestFor(CollisionType::kRearEnd, tta); }

LaneIndex emptyMap() { return LaneIndex(std::make_shared<const LaneMap>()); }

EgoTest testOf(double tta) { return {straightAttack(), rearEnd(tta), EgoVehicle{kEgoSize, 0.0}}; }

AgentState standing(double time, double x) { return {time, {x, 0.0, 0.0}, Vector2::Zero()}; }

std::vector<Track> frame(double time) {
  return {Track{"other", AgentClass::kCar, kCarSize, {standing(time, -50.0)}}};
}

TEST(EgoTest, IgnoresAgentsThatAreNotFinite) {
  const double nan = std::nan("");
  EgoTest test = testOf(1.0);
  test.addAgents(
      {Track{"sizeless", AgentClass::kCar, {nan, 2.0}, {standing(kNow, 5.0)}},
       Track{"nowhere", AgentClass::kCar, kCarSize, {{kNow, {5.0, 0.0, nan}, {0.0, 0.0}}}}});
  for (int i = 0; i <= 40; ++i) test.addEgo(standing(kNow + 0.1 * i, 12.0));
  const auto report = test.outcome(emptyMap(), shippedOptions().verification);
  ASSERT_TRUE(report);
  EXPECT_TRUE(report->contact);
  EXPECT_EQ(report->first_other_id, "");
}

TEST(EgoTest, HasNoOutcomeBeforeTheContact) {
  EgoTest test = testOf(1.0);
  for (double t = 0.0; t < 0.9; t += 0.1) {
    test.addEgo(standing(kNow + t, 15.0));
    EXPECT_FALSE(test.outcome(emptyMap(), shippedOptions().verification)) << t;
  }
}

TEST(EgoTest, ReportsTheContactOnceOtherAgentsAreKnownUpToIt) {
  EgoTest test = testOf(1.0);
  const double contact = (15.0 - 0.5 * (kEgoSize.length + kCarSize.length)) / kSpeed;
  test.addAgents(frame(kNow));
  for (double t = 0.0; t < 1.55; t += 0.1) test.addEgo(standing(kNow + t, 15.0));
  EXPECT_FALSE(test.outcome(emptyMap(), shippedOptions().verification));
  test.addAgents(frame(kNow + 1.5));
  const auto report = test.outcome(emptyMap(), shippedOptions().verification);
  ASSERT_TRUE(report);
  EXPECT_TRUE(report->verified());
  EXPECT_NEAR(report->contact_time, kNow + contact, 1e-3);
}

TEST(EgoTest, SeesTheAttackerOverALowAgent) {
  const auto visibleFor = [](std::optional<double> height) {
    EgoTest test = testOf(2.5);
    for (int i = 0; i <= 30; ++i) {
      const double time = kNow + 0.1 * i;
      test.addEgo(standing(time, 30.0));
      const AgentState between{time, {18.0, i <= 10 ? 0.0 : 20.0, 0.0}, Vector2::Zero()};
      test.addAgents({Track{"between", AgentClass::kCar, kCarSize, {between}, height}});
    }
    return test.outcome(emptyMap(), shippedOptions().verification).value().conditions.visible_for;
  };
  EXPECT_LT(visibleFor(std::nullopt), 1.7) << "as high as the attacker, away 1.1 s after t0";
  EXPECT_GT(visibleFor(0.5), 2.0);
}

TEST(EgoTest, HasNoOutcomeForAnEgoThatStartsTooLate) {
  for (const double seen_from : {0.0, 0.1, 2.0}) {
    EgoTest test = testOf(1.0);
    for (double t = seen_from; t < 3.15; t += 0.1) test.addEgo(standing(kNow + t, 15.0));
    test.addAgents(frame(kNow + 3.1));
    EXPECT_EQ(test.outcome(emptyMap(), shippedOptions().verification).has_value(), seen_from == 0.0)
        << seen_from;
  }
}

TEST(EgoTest, JudgesTheStartAgainstTheRecordedHeading) {
  EgoTest test = testOf(1.0);
  const Track turned{
      "attacker", AgentClass::kCar, kCarSize, {{kNow, {0.0, 0.0, 1.0}, Vector2::Zero()}}};
  test.addAgents({turned});
  test.addAgents(frame(kNow + 1.5));
  for (double t = 0.0; t < 1.55; t += 0.1) test.addEgo(standing(kNow + t, 15.0));
  const auto report = test.outcome(emptyMap(), shippedOptions().verification);
  ASSERT_TRUE(report);
  EXPECT_FALSE(report->limits_kept);
}

TEST(EgoTest, AChangedTrajectoryIsTestedAgainstAllStates) {
  AttackerTrajectory aside = straightAttack();
  for (TrajectoryPoint& point : aside.points) point.pose.y = 10.0;
  EgoTest test(aside, rearEnd(1.0), EgoVehicle{kEgoSize, 0.0});
  test.addAgents(frame(kNow));
  for (double t = 0.0; t < 1.55; t += 0.1) test.addEgo(standing(kNow + t, 15.0));
  test.addAgents(frame(kNow + 1.5));
  EXPECT_FALSE(test.outcome(emptyMap(), shippedOptions().verification));
  test.changeTrajectory(straightAttack());
  const auto report = test.outcome(emptyMap(), shippedOptions().verification);
  ASSERT_TRUE(report);
  const double contact = (15.0 - 0.5 * (kEgoSize.length + kCarSize.length)) / kSpeed;
  EXPECT_NEAR(report->contact_time, kNow + contact, 1e-3);
  EXPECT_THROW(test.changeTrajectory({"attacker", AgentClass::kCar, kCarSize, {}}),
               std::invalid_argument);
}

}  // namespace
}  // namespace forge
