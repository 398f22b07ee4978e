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

/// A bend to the left of 30 m radius after 30 m straight on along +x, 120 m in all.
ReferencePath bend() {
  constexpr double kRadius = 30.0;
  std::vector<Vector2> points = {{0.0, 0.0}, {15.0, 0.0}, {30.0, 0.0}};
  for (int i = 1; i <= 90; ++i) {
    const double angle = i / kRadius;
    points.emplace_back(30.0 + kRadius * std::sin(angle), kRadius * (1.0 - std::cos(angle)));
  }
  return ReferencePath(Polyline(points));
}

std::vector<TrajectoryPoint> driven(const QuinticFamily& family, const DriveStart& start,
                                    const Arrival& arrival) {
  std::vector<TrajectoryPoint> points;
  EXPECT_TRUE(family.drive(start, arrival, points));
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

TEST(QuinticFamily, InMapAxesReachesTheStartAndTheArrival) {
  std::mt19937 random(1);
  for (int i = 0; i < 200; ++i) {
    const RandomDrive drive(random);
    const auto points = driven({}, drive.start, drive.arrival);
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

TEST(QuinticFamily, GoesStraightOnAfterTheArrival) {
  const Pose2 target{30.0, 3.0, 0.2};
  const Arrival arrival = arrivalAt(2.55, target, 11.0);
  const ReferencePath path = bend();
  for (const QuinticFamily& family : {QuinticFamily(), QuinticFamily(path)}) {
    const auto points = driven(family, startAt({}, 12.0), arrival);
    for (std::size_t i = 26; i < points.size(); ++i) {
      const double after = kStep * static_cast<double>(i) - 2.55;
      expectPose(points[i].pose, compose(target, {11.0 * after, 0.0, 0.0}), 1e-9);
      EXPECT_EQ(points[i].speed, 11.0);
      if (i < 28) continue;
      EXPECT_NEAR(points[i].acceleration, 0.0, 1e-9);
      EXPECT_NEAR(points[i].curvature, 0.0, 1e-9);
    }
  }
}

TEST(QuinticFamily, OnACurvedPathReachesTheStartAndTheArrival) {
  const ReferencePath path = bend();
  std::mt19937 random(2);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  for (int i = 0; i < 200; ++i) {
    const double from = between(5.0, 50.0);
    const double speed = between(5.0, 12.0);
    const double time = kStep * std::floor(between(20.0, 50.0));
    const auto beside = [&](double s) {
      return compose(path.at(s).pose, {0.0, between(-2.0, 2.0), between(-0.2, 0.2)});
    };
    const Pose2 start = beside(from);
    const Arrival arrival = arrivalAt(time, beside(from + speed * time), speed);
    const auto points = driven(QuinticFamily(path), startAt(start, speed), arrival);
    // Places a metre apart are joined by chords, which leaves centimetres and hundredths.
    expectPose(points.front().pose, start, 0.05);
    EXPECT_NEAR(points.front().speed, speed, 0.02 * speed);
    const std::size_t end = indexAt(time);
    expectPose(points.at(end).pose, arrival.pose, 1e-9);
    const Pose2 almost = points.at(end - 1).pose;
    const Pose2 back = compose(arrival.pose, {-kStep * speed, 0.0, 0.0});
    EXPECT_NEAR((almost.position() - back.position()).norm(), 0.0, 0.05);
    EXPECT_NEAR(angleBetween(almost.yaw, back.yaw), 0.0, 0.05);
  }
}

TEST(QuinticFamily, OnACurvedPathKeepsToTheLane) {
  const ReferencePath path = bend();
  const Pose2 start = path.at(10.0).pose;
  const Arrival arrival = arrivalAt(6.0, path.at(70.0).pose, 10.0);
  double farthest_in_lane = 0.0;
  double farthest_freely = 0.0;
  const auto lateral = [&](const TrajectoryPoint& point) {
    const Pose2 place = path.at(path.project(point.pose.position())).pose;
    return std::abs(relativeTo(place, point.pose).y);
  };
  for (const auto& point : driven(QuinticFamily(path), startAt(start, 10.0), arrival)) {
    farthest_in_lane = std::max(farthest_in_lane, lateral(point));
  }
  for (const auto& point : driven({}, startAt(start, 10.0), arrival)) {
    farthest_freely = std::max(farthest_freely, lateral(point));
  }
  EXPECT_LT(farthest_in_lane, 0.05);
  EXPECT_GT(farthest_freely, 1.0) << "or the bend would prove nothing";
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

TEST(QuinticFamily, DerivedSpeedAccelerationAndCurvatureAgreeWithThePositions) {
  std::mt19937 random(3);
  for (int n = 0; n < 100; ++n) {
    const RandomDrive drive(random);
    const auto points = driven({}, drive.start, drive.arrival);
    for (std::size_t i = 2; i + 2 < indexAt(drive.arrival.time); ++i) {
      if (points[i].speed < 2.0) continue;
      expectDerived(points, i, 0.05, 0.2);
    }
  }
}

TEST(QuinticFamily, HasNoMotionForAnArrivalAgainstThePath) {
  const ReferencePath path = bend();
  std::vector<TrajectoryPoint> points;
  const Pose2 there = path.at(40.0).pose;
  for (const auto& [turn, drivable] : std::vector<std::pair<double, bool>>{
           {0.0, true}, {1.2, true}, {1.45, false}, {M_PI, false}}) {
    for (const double sign : {1.0, -1.0}) {
      const Pose2 target = compose(there, {0.0, 0.0, sign * turn});
      EXPECT_EQ(QuinticFamily(path).drive(startAt(path.at(10.0).pose, 10.0),
                                          arrivalAt(3.0, target, 10.0), points),
                drivable)
          << sign * turn;
      EXPECT_EQ(QuinticFamily(path).drive(
                    startAt(compose(path.at(10.0).pose, {0.0, 0.0, sign * turn}), 10.0),
                    arrivalAt(3.0, there, 10.0), points),
                drivable)
          << sign * turn << " at the start";
      EXPECT_TRUE(QuinticFamily().drive(startAt({}, 10.0), arrivalAt(3.0, target, 10.0), points));
    }
  }
}

}  // namespace
}  // namespace forge
