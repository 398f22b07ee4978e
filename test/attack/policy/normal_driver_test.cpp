#include "collision_forge/attack/policy/normal_driver.h"

#include <gtest/gtest.h>

#include <limits>

#include "attack/policy/policy_scenes.h"
#include "collision_forge/attack/verify/drive_check.h"
#include "collision_forge/attack/verify/verification.h"

namespace forge {
namespace {

constexpr std::size_t kSteps = 61;  // 6 s

class DriveOnTest : public testing::Test {
 protected:
  std::vector<TrajectoryPoint> driveFrom(const Pose2& middle, double speed,
                                         const std::vector<Track>& others, const LaneIndex& lanes) {
    const DriveLimits limits = driveLimitsOf(vehicle_, attack_.verification);
    state_ = driveStateOf(TrajectoryPoint{kNow, middle, speed, 0.0, 0.0}, limits);
    Future future;
    future.ego = straightTrack(kEgoId, kEgoSize, {0.0, 150.0, 0.0}, 0.0, kNow, kNow, kNow + 10.0);
    future.agents = others;
    const auto points = driveOn({vehicle_, state_, kNow, kSteps, future, lanes}, attack_);
    EXPECT_EQ(points.size(), kSteps);
    EXPECT_EQ(points.front().time, kNow);
    const auto broken =
        findBrokenDrive(points, state_, std::numeric_limits<double>::infinity(), limits);
    EXPECT_FALSE(broken) << describe(*broken);
    return points;
  }

  const AttackOptions attack_ = shippedOptions();
  const Track vehicle_ = pastTrack("car", kCarSize, {0.0, 0.0, 0.0}, 0.0);
  const LaneIndex road_{twoLaneRoad()};
  DriveState state_;
};

TEST_F(DriveOnTest, OnAFreeRoadItKeepsItsSpeedAndComesBackToItsLane) {
  const auto points = driveFrom({0.0, 1.2, 0.1}, 9.0, {}, road_);
  EXPECT_NEAR(points.back().speed, 9.0, 0.6);
  EXPECT_NEAR(points.back().pose.y, 0.0, 0.35);
  EXPECT_NEAR(points.back().pose.yaw, 0.0, 0.05);
}

TEST_F(DriveOnTest, StopsBehindWhoStandsInItsWay) {
  const Track wall = futureTrack("wall", kCarSize, {35.0, 0.0, 0.0}, 0.0);
  const auto points = driveFrom({0.0, 0.0, 0.0}, 10.0, {wall}, road_);
  EXPECT_FALSE(firstTouch(points, kCarSize, {&wall}));
  EXPECT_LT(points.back().pose.x, 35.0 - kCarSize.length);
}

TEST_F(DriveOnTest, WhereNobodyCanStopInTimeItTouchesAsLateAsCanBe) {
  const Track wall = futureTrack("wall", kCarSize, {11.0, 0.0, 0.0}, 0.0);
  const auto points = driveFrom({0.0, 0.0, 0.0}, 15.0, {wall}, road_);
  EXPECT_TRUE(firstTouch(points, kCarSize, {&wall}));
  EXPECT_LT(points[20].speed, 15.0 - 4.0) << "in two seconds";
}

TEST_F(DriveOnTest, WhoIsNearerThanTheClearanceComesNoNearer) {
  const Track wall = futureTrack("wall", kCarSize, {kCarSize.length + 0.1, 0.0, 0.0}, 0.0);
  const auto points = driveFrom({0.0, 0.0, 0.0}, 0.0, {wall}, road_);
  EXPECT_FALSE(firstTouch(points, kCarSize, {&wall}));
}

TEST(FirstTouch, IsTheTimeOfTheFirstPointThatOverlaps) {
  const AttackerTrajectory drive = straightDrive({0.0, 0.0, 0.0}, 10.0, 3.0);
  const Track wall = futureTrack("wall", kCarSize, {20.0, 0.0, 0.0}, 0.0);
  const auto touch = firstTouch(drive.points, kCarSize, {&wall});
  ASSERT_TRUE(touch);
  EXPECT_NEAR(*touch, kNow + 1.6, 1e-9) << "(20 - 4.6) / 10 = 1.54 s";
}

}  // namespace
}  // namespace forge
