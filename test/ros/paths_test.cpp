#include "collision_forge/ros/messages/paths.h"

#include <gtest/gtest.h>

#include <cmath>

#include "collision_forge/ros/messages/conversions.h"

namespace forge {
namespace {

constexpr double kNow = 1600000000.25;  // s, as of today's clocks

/// Along x at 2 m/s from now on, a state every half a second.
Track trackOf(int states) {
  Track track;
  for (int i = 0; i < states; ++i) {
    track.states.push_back({kNow + 0.5 * i, {1.0 * i, 7.0, 0.5}, {2.0, 0.0}});
  }
  return track;
}

void expectFlatAndStamped(const nav_msgs::Path& path, const std::vector<double>& times) {
  EXPECT_EQ(path.header.frame_id, "map");
  ASSERT_EQ(path.poses.size(), times.size());
  EXPECT_EQ(path.header.stamp, path.poses.front().header.stamp);
  for (std::size_t i = 0; i < times.size(); ++i) {
    EXPECT_EQ(path.poses[i].header.frame_id, "map");
    EXPECT_NEAR((path.poses[i].header.stamp - ros::Time(kNow)).toSec(), times[i], 1e-6);
    EXPECT_EQ(path.poses[i].pose.position.z, 0.0);
  }
}

TEST(Paths, OfPointsHasTheirPosesAndTimes) {
  const nav_msgs::Path path = toPath(
      {{kNow, {1.0, 2.0, 0.5}, 3.0, 0.0, 0.0}, {kNow + 0.1, {1.3, 2.1, -2.0}, 3.0, 0.0, 0.0}});
  expectFlatAndStamped(path, {0.0, 0.1});
  EXPECT_EQ(path.poses[1].pose.position.x, 1.3);
  EXPECT_EQ(path.poses[1].pose.position.y, 2.1);
  EXPECT_NEAR(fromMessage(path.poses[1].pose).yaw, -2.0, 1e-9);
}

TEST(Paths, OfATrackBeginsAndEndsBetweenItsStates) {
  const nav_msgs::Path path = toPath(trackOf(5), kNow + 0.25, kNow + 1.75);
  expectFlatAndStamped(path, {0.25, 0.5, 1.0, 1.5, 1.75});
  for (const auto& pose : path.poses) {
    EXPECT_NEAR(pose.pose.position.x, 2.0 * (pose.header.stamp - ros::Time(kNow)).toSec(), 1e-5);
    EXPECT_EQ(pose.pose.position.y, 7.0);
  }
}

TEST(Paths, OfATrackHasStatesAtBothEndsOnce) {
  expectFlatAndStamped(toPath(trackOf(5), kNow, kNow + 2.0), {0.0, 0.5, 1.0, 1.5, 2.0});
}

TEST(Paths, OfATrackEndsWhereThatDoes) {
  expectFlatAndStamped(toPath(trackOf(3), kNow + 0.5, kNow + 9.0), {0.5, 1.0});
}

TEST(Paths, OfNothingIsEmpty) {
  EXPECT_TRUE(toPath(std::vector<TrajectoryPoint>()).poses.empty());
  EXPECT_TRUE(toPath(trackOf(3), kNow + 5.0, kNow + 9.0).poses.empty());
}

}  // namespace
}  // namespace forge
