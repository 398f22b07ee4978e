#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "attack/search/test_scenes.h"
#include "collision_forge/attack/search/trajectory_family.h"

namespace forge {
namespace {

constexpr double kStep = 0.1;  // s

DriveStart startAt(const Pose2& pose, double speed, int points = 61) {
  DriveStart start;
  start.motion.pose = pose;
  start.motion.speed = speed;
  start.now = kNow;
  start.step = kStep;
  start.points = points;
  return start;
}

Arrival arrivalAt(double time, const Pose2& pose, double speed) {
  Arrival arrival;
  arrival.time = time;
  arrival.pose = pose;
  arrival.speed = speed;
  return arrival;
}

std::vector<TrajectoryPoint> driven(const DriveStart& start, const Arrival& arrival) {
  std::vector<TrajectoryPoint> points;
  driveQuintic(start, arrival, points);
  return points;
}

void expectPose(const Pose2& pose, const Pose2& expected, double tolerance) {
  EXPECT_NEAR((pose.position() - expected.position()).norm(), 0.0, tolerance);
  EXPECT_NEAR(angleBetween(expected.yaw, pose.yaw), 0.0, tolerance);
}

/// Motions whose start and arrival head roughly the same way, in map axes.
struct RandomDrive {
  DriveStart start;
  Arrival arrival;

  explicit RandomDrive(std::mt19937& random) {
    const auto between = [&](double low, double high) {
      return std::uniform_real_distribution<double>(low, high)(random);
    };
    const Pose2 pose{between(-500.0, 500.0), between(-500.0, 500.0), between(-M_PI, M_PI)};
    const double speed = between(3.0, 15.0);
    const double end_speed = between(3.0, 15.0);
    const double time = kStep * std::floor(between(15.0, 50.0));
    start = startAt(pose, speed);
    arrival = arrivalAt(
        time,
        compose(pose, {0.5 * (speed + end_speed) * time, between(-4.0, 4.0), between(-0.3, 0.3)}),
        end_speed);
    arrival.start_acceleration = between(-1.0, 1.0);
    arrival.end_acceleration = between(-1.0, 1.0);
  }
};

std::size_t indexAt(double time) { return static_cast<std::size_t>(std::lround(time / kStep)); }

TEST(Quintic, ReachesTheStartAndTheArrival) {
  std::mt19937 random(1);
  for (int i = 0; i < 200; ++i) {
    const RandomDrive drive(random);
    const auto points = driven(drive.start, drive.arrival);
    ASSERT_EQ(points.size(), 61u);
    expectPose(points.front().pose, drive.start.motion.pose, 1e-9);
    EXPECT_NEAR(points.front().speed, drive.start.motion.speed, 1e-9);
    const TrajectoryPoint& end = points.at(indexAt(drive.arrival.time));
    expectPose(end.pose, drive.arrival.pose, 1e-6);
    EXPECT_NEAR(end.speed, drive.arrival.speed, 1e-6);
    for (std::size_t j = 0; j < points.size(); ++j) {
      EXPECT_NEAR(points[j].time, kNow + kStep * static_cast<double>(j), 1e-9);
    }
  }
}

TEST(Quintic, GoesStraightOnAfterTheArrival) {
  const Pose2 target{30.0, 3.0, 0.2};
  const Arrival arrival = arrivalAt(2.55, target, 11.0);
  const auto points = driven(startAt({}, 12.0), arrival);
  for (std::size_t i = 26; i < points.size(); ++i) {
    const double after = kStep * static_cast<double>(i) - 2.55;
    expectPose(points[i].pose, compose(target, {11.0 * after, 0.0, 0.0}), 1e-9);
    EXPECT_EQ(points[i].speed, 11.0);
    if (i < 28) continue;
    EXPECT_NEAR(points[i].acceleration, 0.0, 1e-9);
    EXPECT_NEAR(points[i].curvature, 0.0, 1e-9);
  }
}

/// Compares a point's speed, acceleration and curvature with its neighbours' positions; the
/// curvature is the sharper one of the steps before and after.
void expectDerived(const std::vector<TrajectoryPoint>& points, std::size_t i, double speed_slack,
                   double acceleration_slack) {
  const Vector2 a = points[i - 1].pose.position();
  const Vector2 b = points[i].pose.position();
  const Vector2 c = points[i + 1].pose.position();
  const Vector2 velocity = (c - a) / (2.0 * kStep);
  const Vector2 acceleration = (c - 2.0 * b + a) / (kStep * kStep);
  const double speed = velocity.norm();
  const Vector2 heading = velocity / speed;
  const double across = heading.x() * acceleration.y() - heading.y() * acceleration.x();
  EXPECT_NEAR(points[i].speed, speed, speed_slack) << i;
  EXPECT_NEAR(points[i].acceleration, acceleration.dot(heading), acceleration_slack) << i;
  const double before = angleBetween(points[i - 1].pose.yaw, points[i].pose.yaw) / (b - a).norm();
  const double after = angleBetween(points[i].pose.yaw, points[i + 1].pose.yaw) / (c - b).norm();
  const double sharper = std::abs(before) > std::abs(after) ? before : after;
  EXPECT_NEAR(points[i].curvature, sharper, 1e-9) << i;
  EXPECT_GT(std::abs(points[i].curvature), std::abs(across) / (speed * speed) - 0.01) << i;
  EXPECT_NEAR(angleBetween(std::atan2(heading.y(), heading.x()), points[i].pose.yaw), 0.0, 0.03)
      << i;
}

TEST(Quintic, DerivedSpeedAccelerationAndCurvatureAgreeWithThePositions) {
  std::mt19937 random(3);
  for (int n = 0; n < 100; ++n) {
    const RandomDrive drive(random);
    const auto points = driven(drive.start, drive.arrival);
    for (std::size_t i = 2; i + 2 < indexAt(drive.arrival.time); ++i) {
      if (points[i].speed < 2.0) continue;
      expectDerived(points, i, 0.05, 0.2);
    }
  }
}

}  // namespace
}  // namespace forge
