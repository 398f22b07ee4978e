#include "collision_forge/attack/verify/reversing.h"

#include <gtest/gtest.h>

#include "attack/search/test_scenes.h"
#include "collision_forge/attack/verify/drive_check.h"

namespace forge {
namespace {

/// twoLaneRoad() with the ground of its lanes, a drive to the south at x = 0 and a strip between
/// the two lanes' grounds that is no lane.
std::shared_ptr<LaneMap> roadWithDrive() {
  auto map = twoLaneRoad();
  map->drivable_area = {rectangle(-200.0, -2.0, 200.0, 5.5), rectangle(-2.5, -9.0, 2.5, -2.0)};
  return map;
}

constexpr BoxSize kCar{4.5, 1.8};

TEST(IsInBay, OffTheLanesOnDrivableGround) {
  const LaneIndex lanes(roadWithDrive());
  EXPECT_TRUE(isInBay({{0.0, -5.5, -M_PI / 2}, kCar}, lanes));
  EXPECT_FALSE(isInBay({{0.0, -3.0, -M_PI / 2}, kCar}, lanes)) << "its rear is on the lane";
  EXPECT_FALSE(isInBay({{0.0, -5.5, M_PI / 2}, kCar}, lanes)) << "its front is towards the lane";
  EXPECT_FALSE(isInBay({{0.0, -8.0, -M_PI / 2}, kCar}, lanes)) << "it sticks out of the drive";
  EXPECT_FALSE(isInBay({{0.0, -5.5, -M_PI / 2}, kCar}, LaneIndex(twoLaneRoad())))
      << "the ground is unknown";
}

TEST(BayBehind, TheNearestPlaceOnDrivableGround) {
  const LaneIndex lanes(roadWithDrive());
  const auto back = bayBehind({0.0, 0.0, M_PI / 2}, kCar, lanes);
  ASSERT_TRUE(back);
  EXPECT_NEAR(*back, 2.0 + 0.5 * kCar.length, 0.5);
  EXPECT_FALSE(bayBehind({0.0, 0.0, -M_PI / 2}, kCar, lanes)) << "nothing on the other side";
  EXPECT_FALSE(bayBehind({20.0, 0.0, M_PI / 2}, kCar, lanes)) << "beside the drive";
}

TEST(BayBehind, NotBeyondGroundThatNobodyDrives) {
  auto map = roadWithDrive();
  map->drivable_area[1] = rectangle(-2.5, -11.0, 2.5, -4.0);
  EXPECT_FALSE(bayBehind({0.0, 0.0, M_PI / 2}, kCar, LaneIndex(map)));
  map->walkways = {rectangle(-200.0, -4.0, 200.0, -2.0)};
  EXPECT_TRUE(bayBehind({0.0, 0.0, M_PI / 2}, kCar, LaneIndex(map))) << "across a walkway";
}

/// A car at the drive that reverses straight north from rest with 1 m/s2.
std::vector<TrajectoryPoint> backingOut() {
  std::vector<TrajectoryPoint> points;
  for (int i = 0; i <= 20; ++i) {
    const double time = 0.1 * i;
    const double moved = i == 0 ? 0.0 : 0.5 * time * time;
    points.push_back({kNow + time, {0.0, -5.5 + moved, -M_PI / 2}, -time, -1.0, 0.0});
  }
  points.front().acceleration = 0.0;
  return points;
}

TEST(ImplausibleReversing, NamesTheReason) {
  const LaneIndex lanes(roadWithDrive());
  const BelievabilityOptions options = shippedOptions().verification.believability;
  std::vector<TrajectoryPoint> points = backingOut();
  EXPECT_EQ(implausibleReversing(points, kCar, kNow + 2.0, lanes, options), "");
  for (TrajectoryPoint& point : points) point.pose.x += 2.5;
  EXPECT_EQ(implausibleReversing(points, kCar, kNow + 2.0, lanes, options),
            "does not stand in a bay or a drive at t0");
  points = backingOut();
  for (std::size_t i = 1; i < points.size(); ++i) points[i].pose.x += 2.5;
  EXPECT_NE(implausibleReversing(points, kCar, kNow + 2.0, lanes, options).find("off the road"),
            std::string::npos);
}

TEST(TurnRound, IsItsOwnInverseAndMovesForward) {
  const std::vector<TrajectoryPoint> points = backingOut();
  std::vector<TrajectoryPoint> travelled = points;
  turnRound(travelled);
  EXPECT_NEAR(travelled.back().pose.yaw, M_PI / 2, 1e-12);
  EXPECT_EQ(travelled.back().speed, 2.0);
  EXPECT_EQ(travelled.back().acceleration, 1.0);
  turnRound(travelled);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_NEAR(travelled[i].pose.yaw, points[i].pose.yaw, 1e-12);
    EXPECT_EQ(travelled[i].speed, points[i].speed);
  }
}

/// A vehicle whose rear axle rolls without slip on a circle of `radius` m while it reverses at
/// 2 m/s.
std::vector<TrajectoryPoint> reversingOnACircle(double radius, double axle_to_middle) {
  std::vector<TrajectoryPoint> points;
  for (int i = 0; i <= 20; ++i) {
    const double time = 0.1 * i;
    const double yaw = -2.0 * time / radius;  // backwards on a circle to the left
    const Pose2 axle{radius * std::sin(yaw), radius * (1.0 - std::cos(yaw)), yaw};
    points.push_back(
        {kNow + time, compose(axle, {axle_to_middle, 0.0, 0.0}), -2.0, 0.0, 1.0 / radius});
  }
  return points;
}

/// The single track of reversingLimits() rolls on its leading axle: a vehicle that steers while it
/// reverses keeps "no_slip", which it breaks with the axle of a vehicle that drives forward.
TEST(ReversingLimits, HoldForTheAxleThatDoesNotSteer) {
  const VerificationOptions options = shippedOptions().verification;
  const Track car{"car", AgentClass::kCar, kCar, {}};
  const DriveLimits forward = driveLimitsOf(AgentClass::kCar, kCar, options.drivable);
  const DriveLimits limits = reversingLimits(car, options);
  EXPECT_EQ(limits.axle_to_middle, -forward.axle_to_middle);
  EXPECT_EQ(limits.max_speed, options.drivable.max_reverse_speed);
  std::vector<TrajectoryPoint> points = reversingOnACircle(8.0, forward.axle_to_middle);
  turnRound(points);
  const auto broken =
      findBrokenDrive(points, driveStateOf(points.front(), limits), kNow + 2.0, limits);
  EXPECT_FALSE(broken) << describe(*broken);
  DriveLimits wrong = limits;
  wrong.axle_to_middle = forward.axle_to_middle;
  const auto slip = findBrokenDrive(points, driveStateOf(points.front(), wrong), kNow + 2.0, wrong);
  ASSERT_TRUE(slip);
  EXPECT_STREQ(slip->name, "no_slip");
}

}  // namespace
}  // namespace forge
