#include "attack/quintic_join.h"

#include <gtest/gtest.h>

#include "attack/test_scenes.h"

namespace forge {
namespace {

CollisionPattern patternAt(const Pose2& target, double speed, double tta) {
  CollisionPattern pattern;
  pattern.time = kNow + tta;
  pattern.ego = {{3.0, -2.0, 0.7}, kEgoSize};
  pattern.attacker_offset = relativeTo(pattern.ego.center, target);
  pattern.attacker_speed = speed;
  return pattern;
}

AttackerTrajectory join(const Motion& motion, const CollisionPattern& pattern) {
  const Track attacker{"a", AgentClass::kTruck, {8.0, 2.5}, {}};
  return joinByQuintic(attacker, motion, kNow, pattern, shippedOptions().realization);
}

TEST(JoinByQuintic, NamesTheAttackerAndSamplesEvenlyToTheEndOfTheTail) {
  const auto trajectory = join({{}, 10.0}, patternAt({40.0, 0.0, 0.0}, 10.0, 4.0));
  EXPECT_EQ(trajectory.attacker_id, "a");
  EXPECT_EQ(trajectory.agent_class, AgentClass::kTruck);
  EXPECT_EQ(trajectory.size.length, 8.0);
  ASSERT_EQ(trajectory.points.size(), 61u);
  for (std::size_t i = 0; i < trajectory.points.size(); ++i) {
    EXPECT_NEAR(trajectory.points[i].time, kNow + 0.1 * static_cast<double>(i), 1e-9);
  }
}

TEST(JoinByQuintic, StartsInTheAttackersMotion) {
  const Motion motion{{5.0, 6.0, 2.0}, 8.0, -1.5, 0.4};
  const TrajectoryPoint start =
      join(motion, patternAt({-20.0, 30.0, 2.5}, 10.0, 4.0)).points.front();
  EXPECT_EQ(start.time, kNow);
  EXPECT_DOUBLE_EQ(start.pose.x, 5.0);
  EXPECT_DOUBLE_EQ(start.pose.y, 6.0);
  EXPECT_NEAR(start.pose.yaw, 2.0, 1e-12);
  EXPECT_NEAR(start.speed, 8.0, 1e-12);
  EXPECT_NEAR(start.acceleration, -1.5, 1e-12);
  EXPECT_NEAR(start.curvature, 0.4 / 8.0, 1e-12) << "yaw rate over speed";
}

TEST(JoinByQuintic, IsAtThePatternsPoseAndSpeedAtItsTime) {
  const Pose2 target{30.0, 12.0, 0.9};
  const auto trajectory = join({{}, 10.0, 2.0, -0.1}, patternAt(target, 13.0, 4.0));
  const TrajectoryPoint& impact = trajectory.points.at(40);
  EXPECT_NEAR(impact.pose.x, target.x, 1e-9);
  EXPECT_NEAR(impact.pose.y, target.y, 1e-9);
  EXPECT_NEAR(impact.pose.yaw, target.yaw, 1e-9);
  EXPECT_NEAR(impact.speed, 13.0, 1e-9);
  EXPECT_NEAR(impact.acceleration, 0.0, 1e-9);
  const TrajectoryPoint& before = trajectory.points.at(39);
  EXPECT_NEAR((impact.pose.position() - before.pose.position()).norm(), 1.3, 0.02);
  EXPECT_LT(std::abs(before.acceleration), 2.0) << "the acceleration fades towards the impact";
}

TEST(JoinByQuintic, GoesStraightOnAfterTheImpact) {
  const Pose2 target{30.0, 12.0, 0.9};
  const auto trajectory = join({{}, 10.0}, patternAt(target, 13.0, 4.0));
  for (std::size_t i = 41; i < trajectory.points.size(); ++i) {
    const TrajectoryPoint& point = trajectory.points[i];
    const Pose2 seen = relativeTo(target, point.pose);
    EXPECT_NEAR(seen.x, 13.0 * 0.1 * static_cast<double>(i - 40), 1e-9);
    EXPECT_NEAR(seen.y, 0.0, 1e-9);
    EXPECT_NEAR(seen.yaw, 0.0, 1e-9);
    EXPECT_NEAR(point.speed, 13.0, 1e-9);
    EXPECT_NEAR(point.acceleration, 0.0, 1e-9);
    EXPECT_NEAR(point.curvature, 0.0, 1e-9);
  }
}

TEST(JoinByQuintic, MeetsAnImpactThatFallsBetweenSamples) {
  const Pose2 target{25.0, -4.0, -0.2};
  const auto trajectory = join({{}, 10.0}, patternAt(target, 11.0, 2.37));
  EXPECT_EQ(trajectory.points.size(), 45u);
  const TrajectoryPoint& before = trajectory.points.at(23);
  const TrajectoryPoint& after = trajectory.points.at(24);
  EXPECT_NEAR(relativeTo(target, after.pose).x, 11.0 * 0.03, 1e-9);
  EXPECT_NEAR(relativeTo(target, after.pose).y, 0.0, 1e-9);
  EXPECT_NEAR(after.pose.yaw, target.yaw, 1e-9);
  EXPECT_NEAR(relativeTo(target, before.pose).x, -11.0 * 0.07, 0.01);
  EXPECT_NEAR(relativeTo(target, before.pose).y, 0.0, 0.01);
}

TEST(JoinByQuintic, TrajectoryAlwaysPassesTheImpact) {
  RealizationOptions options = shippedOptions().realization;
  options.tail = options.step;
  const Track attacker{"a", AgentClass::kCar, kCarSize, {}};
  for (double tta = 0.5; tta < 1.5; tta += 0.013) {
    const auto pattern = patternAt({12.0, 0.0, 0.0}, 10.0, tta);
    const auto trajectory = joinByQuintic(attacker, {{}, 10.0}, kNow, pattern, options);
    EXPECT_GE(trajectory.points.back().time, pattern.time) << tta;
  }
}

TEST(JoinByQuintic, SpeedAccelerationAndCurvatureAreThoseOfThePath) {
  RealizationOptions options = shippedOptions().realization;
  options.step = 0.001;
  const Track attacker{"a", AgentClass::kCar, kCarSize, {}};
  const auto points = joinByQuintic(attacker, {{}, 8.0, 1.0, 0.2}, kNow,
                                    patternAt({25.0, 15.0, 1.2}, 9.0, 3.0), options)
                          .points;
  for (std::size_t i = 100; i < 2900; i += 100) {
    const Vector2 before = points[i].pose.position() - points[i - 1].pose.position();
    const Vector2 after = points[i + 1].pose.position() - points[i].pose.position();
    const double turn = before.x() * after.y() - before.y() * after.x();
    EXPECT_NEAR(points[i].speed, 0.5 * (before + after).norm() / 0.001, 1e-4);
    EXPECT_NEAR(points[i].acceleration, (after.norm() - before.norm()) / 1e-6, 1e-2);
    EXPECT_NEAR(points[i].curvature, turn / std::pow(before.norm(), 3), 1e-3);
    EXPECT_NEAR(points[i].pose.yaw, std::atan2((before + after).y(), (before + after).x()), 1e-5);
  }
}

TEST(JoinByQuintic, HoldsTheRecordedYawWhileStanding) {
  const Motion standing{{0.0, 0.0, 1.0}};
  const auto trajectory =
      join(standing, patternAt(compose(standing.pose, {20.0, 0.0, 0.0}), 10.0, 4.0));
  for (const TrajectoryPoint& point : trajectory.points) {
    EXPECT_NEAR(point.pose.yaw, 1.0, 1e-9) << point.time;
  }
  EXPECT_EQ(trajectory.points.front().curvature, 0.0);
  EXPECT_EQ(trajectory.points.front().speed, 0.0);
}

TEST(JoinByQuintic, StandsInThePatternsPoseAfterStopping) {
  const auto trajectory = join({{}, 10.0}, patternAt({20.0, 0.0, 0.0}, 0.0, 4.0));
  for (std::size_t i = 40; i < trajectory.points.size(); ++i) {
    EXPECT_NEAR(trajectory.points[i].pose.x, 20.0, 1e-9);
    EXPECT_NEAR(trajectory.points[i].pose.yaw, 0.0, 1e-9);
    EXPECT_NEAR(trajectory.points[i].speed, 0.0, 1e-9);
  }
}

TEST(JoinByQuintic, HoldsTheYawOfTheMotionWhenItComesToAHaltBeforeTheImpact) {
  const Motion standing{{0.0, 0.0, 0.7}};
  const auto points = join(standing, patternAt({10.0, 10.0, 0.8}, 0.0, 4.0)).points;
  EXPECT_EQ(points.at(0).pose.yaw, 0.7) << "as recorded";
  EXPECT_LT((points.at(40).pose.position() - points.at(39).pose.position()).norm(), 0.01);
  EXPECT_NEAR(points.at(39).pose.yaw, M_PI_4, 1e-9) << "as it drove";
  EXPECT_NEAR(points.at(40).pose.yaw, 0.8, 1e-12) << "as the pattern says";
}

TEST(JoinByQuintic, KeepsAReversingAttackersVelocity) {
  const auto trajectory = join({{}, -5.0}, patternAt({-20.0, 0.0, M_PI}, 5.0, 4.0));
  for (const TrajectoryPoint& point : trajectory.points) {
    EXPECT_NEAR(point.pose.x, -5.0 * (point.time - kNow), 1e-9);
    EXPECT_NEAR(std::abs(point.pose.yaw), M_PI, 1e-9) << "yaw follows the motion";
  }
}

TEST(JoinByQuintic, NeedsAnImpactAfterNow) {
  EXPECT_THROW(join({{}, 5.0}, patternAt({1.0, 0.0, 0.0}, 5.0, 0.0)), std::invalid_argument);
}

}  // namespace
}  // namespace forge
