#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "attack/search/test_scenes.h"
#include "collision_forge/attack/search/trajectory_family.h"
#include "collision_forge/attack/verify/limits.h"

namespace forge {
namespace {

constexpr double kStep = 0.1;  // s
constexpr double kRounding = 1.0 + 1e-6;

/// A bicycle within the limits of config/, and the motion from a pose.
struct Case {
  AttackOptions options = shippedOptions();
  DriveStart start;
  Arrival arrival;
  std::vector<TrajectoryPoint> points;

  Case(const Pose2& pose, double speed, double time, const Pose2& target, double end_speed) {
    start.motion.pose = pose;
    start.motion.speed = speed;
    start.now = kNow;
    start.step = kStep;
    start.points = static_cast<int>(std::lround(time / kStep)) + 11;
    arrival.time = time;
    arrival.pose = target;
    arrival.speed = end_speed;
  }
  bool drive() {
    const BicycleFamily bicycle(options.verification.limits);
    const auto knots = bicycle.solve(start, arrival);
    if (knots) bicycle.roll(start, *knots, arrival.time, points);
    return knots.has_value();
  }
  /// The point at the arrival, which must be at a whole step.
  const TrajectoryPoint& end() const {
    return points.at(static_cast<std::size_t>(std::lround(arrival.time / kStep)));
  }
  double miss() const { return (end().pose.position() - arrival.pose.position()).norm(); }
  void expectWithinLimits() const {
    VehicleLimits limits = options.verification.limits;
    limits.max_forward_acceleration *= kRounding;
    limits.max_braking *= kRounding;
    limits.max_total_acceleration *= kRounding;
    limits.max_curvature *= kRounding;
    limits.max_speed *= kRounding;
    const auto broken = findBrokenLimit(points, start.motion.pose.yaw, 1e9, limits);
    EXPECT_FALSE(broken) << describe(*broken);
  }
};

TEST(BicycleFamily, StartsAtTheAttackersStateAndReturnsEveryPoint) {
  Case motion({3.0, -4.0, 1.0}, 7.0, 3.0, compose({3.0, -4.0, 1.0}, {21.0, 1.0, 0.1}), 7.0);
  ASSERT_TRUE(motion.drive());
  ASSERT_EQ(motion.points.size(), 41u);
  EXPECT_EQ(motion.points[0].pose.x, 3.0);
  EXPECT_EQ(motion.points[0].pose.y, -4.0);
  EXPECT_EQ(motion.points[0].pose.yaw, 1.0);
  EXPECT_EQ(motion.points[0].speed, 7.0);
  for (std::size_t i = 0; i < motion.points.size(); ++i) {
    EXPECT_NEAR(motion.points[i].time, kNow + kStep * static_cast<double>(i), 1e-9);
  }
}

TEST(BicycleFamily, KnotsAreLinearInBetweenAndClampedToTheLimits) {
  Case motion({}, 8.0, 4.0, {}, 0.0);
  SteeringKnots knots;
  knots.acceleration = {0.0, 2.0, 2.0, 100.0, -100.0};
  knots.curvature = {0.0, 0.02, -0.02, 9.0, 0.0};
  BicycleFamily(motion.options.verification.limits).roll(motion.start, knots, 4.0, motion.points);
  EXPECT_NEAR(motion.points[5].acceleration, 1.0, 1e-9);
  EXPECT_NEAR(motion.points[5].curvature, 0.01, 1e-9);
  EXPECT_NEAR(motion.points[15].acceleration, 2.0, 1e-9);
  EXPECT_NEAR(motion.points[15].curvature, 0.0, 1e-9);
  EXPECT_NEAR(motion.points[30].acceleration, 5.0, 1e-9);
  EXPECT_NEAR(motion.points[39].acceleration, -8.0, 1e-9);
  EXPECT_EQ(motion.points[40].acceleration, 0.0);
  motion.expectWithinLimits();
}

TEST(BicycleFamily, NeverBreaksTheLimitsAndAlwaysArrivesOnRandomArrivals) {
  std::mt19937 random(11);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  int driven = 0;
  for (int i = 0; i < 1500; ++i) {
    const Pose2 pose{between(-500.0, 500.0), between(-500.0, 500.0), between(-M_PI, M_PI)};
    const double speed = i % 5 == 0 ? 0.0 : between(0.0, 24.0);
    const Pose2 local{between(-10.0, 90.0), between(-30.0, 30.0), between(-M_PI, M_PI)};
    const double time = kStep * std::floor(between(5.0, 60.0));
    Case motion(pose, speed, time, compose(pose, local), between(0.5, 24.0));
    if (!motion.drive()) continue;
    SCOPED_TRACE(i);
    ++driven;
    EXPECT_LE(motion.miss(), BicycleFamily::kMaxMiss + 1e-6);
    motion.expectWithinLimits();
  }
  EXPECT_GT(driven, 200);
}

TEST(BicycleFamily, HasNoMotionToAnUnreachableArrival) {
  const auto reaches = [](const Pose2& target, double speed, double time) {
    return Case({}, speed, time, target, 10.0).drive();
  };
  EXPECT_FALSE(reaches({200.0, 0.0, 0.0}, 10.0, 4.0)) << "too far";
  EXPECT_FALSE(reaches({2.0, 0.0, 0.0}, 20.0, 4.0)) << "cannot stop in time";
  EXPECT_FALSE(reaches({0.0, 8.0, 0.0}, 15.0, 1.0)) << "sideways";
  EXPECT_FALSE(reaches({-20.0, 0.0, 0.0}, 0.0, 4.0)) << "backwards";
  EXPECT_FALSE(reaches({0.5, 3.0, 0.0}, 0.0, 5.0)) << "within its turning circle";
}

TEST(BicycleFamily, AcceptsAMissOfUpToMaxMiss) {
  // 20 m/s stop in 25 m at 8 m/s2.
  Case near({}, 20.0, 4.0, {24.5, 0.0, 0.0}, 0.0);
  ASSERT_TRUE(near.drive());
  EXPECT_GT(near.miss(), 0.1);
  EXPECT_LE(near.miss(), BicycleFamily::kMaxMiss);
  EXPECT_FALSE(Case({}, 20.0, 4.0, {23.0, 0.0, 0.0}, 0.0).drive());
}

}  // namespace
}  // namespace forge
