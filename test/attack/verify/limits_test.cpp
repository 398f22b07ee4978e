#include "collision_forge/attack/verify/limits.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "attack/search/test_scenes.h"

namespace forge {
namespace {

const VehicleLimits kLimits = shippedOptions().verification.limits;
constexpr double kEnd = kNow + 2.0;

/// A drive at 10 m/s with one point changed.
AttackerTrajectory with(const TrajectoryPoint& values, std::size_t index = 5) {
  AttackerTrajectory trajectory = straightDrive({}, 10.0, 3.0);
  TrajectoryPoint& point = trajectory.points.at(index);
  point.speed = values.speed;
  point.acceleration = values.acceleration;
  point.curvature = values.curvature;
  return trajectory;
}

std::string broken(const AttackerTrajectory& trajectory, double start_yaw = 0.0,
                   double until = kEnd) {
  const auto found = findBrokenLimit(trajectory.points, start_yaw, until, kLimits);
  EXPECT_EQ(keepsLimits(trajectory.points, start_yaw, until, kLimits),
            !found && !findBrokenPositions(trajectory.points, until, kLimits));
  return found ? found->name : "";
}

/// Speed, acceleration, curvature of one point.
TrajectoryPoint values(double speed, double acceleration, double curvature) {
  return {0.0, {}, speed, acceleration, curvature};
}

/// At 1 m/s, turned by `turn` in all after the `index`-th point.
AttackerTrajectory slowTurn(double turn, std::size_t index) {
  AttackerTrajectory trajectory = straightDrive({}, 1.0, 3.0);
  for (std::size_t i = index; i < trajectory.points.size(); ++i) {
    trajectory.points[i].pose.yaw = turn;
  }
  return trajectory;
}

TEST(FindBrokenLimit, IsEmptyAtConstantVelocity) {
  EXPECT_EQ(broken(straightDrive({}, 10.0, 3.0)), "");
  EXPECT_EQ(broken(straightDrive({}, 0.0, 3.0)), "");
}

TEST(FindBrokenLimit, NamesEachViolatedLimitAndNoneJustBelow) {
  EXPECT_EQ(broken(with(values(10.0, 5.01, 0.0))), "max_forward_acceleration");
  EXPECT_EQ(broken(with(values(10.0, 4.99, 0.0))), "");
  EXPECT_EQ(broken(with(values(10.0, -8.01, 0.0))), "max_braking");
  EXPECT_EQ(broken(with(values(10.0, -7.99, 0.0))), "");
  EXPECT_EQ(broken(with(values(10.0, 4.0, 0.0693))), "max_total_acceleration") << "hypot(4, 6.93)";
  EXPECT_EQ(broken(with(values(10.0, 4.0, 0.0692))), "");
  EXPECT_EQ(broken(with(values(10.0, 0.0, -0.0801))), "max_total_acceleration");
  EXPECT_EQ(broken(with(values(10.0, 0.0, -0.0799))), "");
  EXPECT_EQ(broken(with(values(25.01, 0.0, 0.0))), "max_speed");
  EXPECT_EQ(broken(with(values(24.99, 0.0, 0.0))), "");
  EXPECT_EQ(broken(with(values(3.0, 0.0, 0.201))), "max_curvature");
  EXPECT_EQ(broken(with(values(3.0, 0.0, -0.201))), "max_curvature");
  EXPECT_EQ(broken(with(values(3.0, 0.0, -0.199))), "");
  EXPECT_EQ(broken(with(values(-0.01, 0.0, 0.0))), "no_reversing");
  EXPECT_EQ(broken(with(values(0.0, 0.0, 0.0))), "");
}

TEST(FindBrokenLimit, ReturnsTheValueAndTheLimit) {
  const auto found = findBrokenLimit(with(values(10.0, -9.5, 0.0)).points, 0.0, kEnd, kLimits);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->value, 9.5);
  EXPECT_EQ(found->limit, 8.0);
  EXPECT_EQ(describe(*found), "max_braking 9.500 > 8.000");
}

TEST(FindBrokenLimit, ReturnsTheWorstByRatio) {
  AttackerTrajectory trajectory = with(values(26.0, 0.0, 0.0), 3);
  trajectory.points[7].acceleration = 7.5;
  trajectory.points[9].acceleration = -8.1;
  const auto found = findBrokenLimit(trajectory.points, 0.0, kEnd, kLimits);
  ASSERT_TRUE(found);
  EXPECT_STREQ(found->name, "max_forward_acceleration");
  EXPECT_EQ(found->value, 7.5);
}

TEST(FindBrokenLimit, ChecksUpToTheFirstPointAtOrAfterTheEnd) {
  const TrajectoryPoint fast = values(30.0, 0.0, 0.0);
  EXPECT_EQ(broken(with(fast, 19), 0.0, kNow + 1.85), "max_speed");
  EXPECT_EQ(broken(with(fast, 20), 0.0, kNow + 1.85), "");
  EXPECT_EQ(broken(with(fast, 0), 0.0, kNow), "max_speed");
  EXPECT_EQ(broken(with(fast, 30), 0.0, kNow + 99.0), "max_speed");
}

TEST(FindBrokenLimit, RejectsValuesThatAreNotFinite) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(broken(with(values(kNan, 0.0, 0.0))), "finite");
  EXPECT_EQ(broken(with(values(10.0, kNan, 0.0))), "finite");
  EXPECT_EQ(broken(with(values(10.0, 0.0, kNan))), "finite");
  AttackerTrajectory nowhere = straightDrive({}, 10.0, 3.0);
  nowhere.points[4].pose.y = kNan;
  EXPECT_EQ(broken(nowhere), "finite");
}

TEST(FindBrokenLimit, StartsAtTheRecordedYaw) {
  EXPECT_EQ(broken(straightDrive({}, 10.0, 3.0), 0.174), "");
  EXPECT_EQ(broken(straightDrive({}, 10.0, 3.0), -0.175), "heading_slack");
  EXPECT_EQ(broken(straightDrive({0.0, 0.0, 3.1}, 10.0, 3.0), -3.1), "") << "the shorter turn";
  EXPECT_EQ(broken(straightDrive({}, 0.0, 3.0), M_PI), "heading_slack");
}

TEST(FindBrokenLimit, AllowsSlowHeadingChangeByTheSlackAndTheDistance) {
  // The tenth point of the slow stretch is a metre along.
  EXPECT_EQ(broken(slowTurn(0.1745 + 0.3 - 0.001, 10)), "");
  EXPECT_EQ(broken(slowTurn(0.1745 + 0.3 + 0.001, 10)), "heading_slack");
  EXPECT_EQ(broken(slowTurn(-0.1745 - 0.3 - 0.001, 10)), "heading_slack");
  EXPECT_EQ(broken(slowTurn(0.1745 + 0.001, 0), 0.1745 + 0.001), "");
}

TEST(FindBrokenLimit, MeasuresSlowHeadingChangeFromTheStartOfTheSlowStretch) {
  AttackerTrajectory trajectory = straightDrive({}, 10.0, 3.0);
  for (std::size_t i = 0; i < trajectory.points.size(); ++i) {
    // Turning by 0.05 rad a point while fast, standing from the eleventh point on.
    trajectory.points[i].pose = {std::min(static_cast<double>(i), 10.0), 0.0,
                                 0.05 * std::min(static_cast<double>(i), 10.0)};
    if (i > 10) trajectory.points[i].speed = 0.0;
  }
  EXPECT_EQ(broken(trajectory), "");
  trajectory.points[15].pose.yaw = 0.5 + 0.17;
  EXPECT_EQ(broken(trajectory), "");
  trajectory.points[15].pose.yaw = 0.5 + 0.18;
  EXPECT_EQ(broken(trajectory), "heading_slack");
}

/// A drive whose speed, and curvature, change after the tenth point, a second on.
AttackerTrajectory changingDrive(double from, double to, double turn = 0.0) {
  AttackerTrajectory trajectory = straightDrive({}, from, 3.0);
  for (std::size_t i = 11; i < trajectory.points.size(); ++i) {
    TrajectoryPoint& point = trajectory.points[i];
    point.pose = compose(trajectory.points[i - 1].pose, {0.1 * to, 0.0, turn});
    point.speed = to;
  }
  return trajectory;
}

std::string brokenPositions(const AttackerTrajectory& trajectory, double until = kEnd) {
  const auto found = findBrokenPositions(trajectory.points, until, kLimits);
  return found ? describe(*found) : "";
}

TEST(FindBrokenPositions, IsEmptyAtConstantVelocity) {
  EXPECT_EQ(brokenPositions(straightDrive({}, 10.0, 3.0)), "");
  EXPECT_EQ(brokenPositions(straightDrive({}, 0.0, 3.0)), "");
  EXPECT_EQ(brokenPositions({}), "");
}

TEST(FindBrokenPositions, ChecksTheTotalAccelerationBySecondDifferences) {
  EXPECT_EQ(brokenPositions(changingDrive(10.0, 9.2)), "");
  EXPECT_EQ(brokenPositions(changingDrive(10.0, 9.19)), "max_total_acceleration 8.050 > 8.000");
  EXPECT_EQ(brokenPositions(changingDrive(10.0, 10.0, 0.08)), "") << "8 m/s2 across";
  EXPECT_EQ(brokenPositions(changingDrive(10.0, 10.0, 0.09)),
            "max_total_acceleration 8.947 > 8.000");
}

TEST(FindBrokenPositions, ChecksTheStoredSpeedAgainstNeighbouringSteps) {
  AttackerTrajectory trajectory = straightDrive({}, 10.0, 3.0);
  trajectory.points[5].speed = 10.29;
  EXPECT_EQ(brokenPositions(trajectory), "");
  trajectory.points[5].speed = 9.69;
  EXPECT_EQ(brokenPositions(trajectory), "speed_of_positions 0.310 > 0.300");
  EXPECT_EQ(brokenPositions(straightDrive({}, -1.0, 3.0)), "") << "backwards";
}

TEST(Effort, IsZeroAtConstantVelocityAndOneAtTheLimit) {
  AttackerTrajectory trajectory = straightDrive({}, 10.0, 3.0);
  EXPECT_EQ(effort(trajectory.points, kEnd, kLimits), 0.0);
  for (TrajectoryPoint& point : trajectory.points) point.acceleration = -8.0;
  EXPECT_DOUBLE_EQ(effort(trajectory.points, kEnd, kLimits), 1.0);
  for (TrajectoryPoint& point : trajectory.points) {
    point.acceleration = 0.0;
    point.curvature = 0.04;
  }
  EXPECT_DOUBLE_EQ(effort(trajectory.points, kEnd, kLimits), 0.25);
}

TEST(FastestSteering, IsTheGreatestRateOfCurvatureInEitherDirection) {
  AttackerTrajectory trajectory = straightDrive({}, 10.0, 3.0);
  EXPECT_EQ(fastestSteering(trajectory.points, kEnd, kLimits), 0.0);
  trajectory.points[4].curvature = 0.01;
  trajectory.points[5].curvature = -0.02;
  trajectory.points[6].curvature = -0.02;
  EXPECT_NEAR(fastestSteering(trajectory.points, kEnd, kLimits), 0.3, 1e-6) << "0.03 in 0.1 s";
  EXPECT_EQ(fastestSteering({}, kEnd, kLimits), 0.0);
}

}  // namespace
}  // namespace forge
