#include "collision_forge/ros/injection/post_crash_ego.h"

#include <gtest/gtest.h>

#include <cmath>

#include "collision_forge/planner_test/settings/config.h"
#include "collision_forge/ros/messages/topic_names.h"

namespace forge {
namespace {

/// From `box` sideways along y from 10 s on; it stands at 11 s, 2 m on.
PostCrashMotion sideways(const Pose2& box) {
  DriveLimitOptions limits =
      loadConfig(COLLISION_FORGE_SOURCE_DIR "/config").attack.verification.drivable;
  for (DriveLimits& row : limits.rows) row.max_braking = 4.0;
  const CrashedVehicle vehicle{AgentClass::kCar, {4.0, 2.0}, {10.0, box, {0.0, 4.0}}};
  return {vehicle, vehicle, limits};
}

geometry_msgs::TransformStamped transformAt(double time, const std::string& child) {
  geometry_msgs::TransformStamped transform;
  transform.header.stamp = ros::Time(time);
  transform.header.frame_id = names::kMapFrame;
  transform.child_frame_id = child;
  transform.transform.translation.x = time;
  transform.transform.translation.z = time / 10.0;
  transform.transform.rotation.w = 1.0;
  return transform;
}

tf2_msgs::TFMessage messageAt(double time) {
  tf2_msgs::TFMessage message;
  message.transforms = {transformAt(time, names::kBaseFrame), transformAt(time, "camera")};
  return message;
}

TEST(PostCrashEgo, MovesOnlyBaseLinkAndOnlyAfterTheContact) {
  PostCrashEgo ego(sideways({7.0, 1.0, 0.0}), 1.5);
  EXPECT_EQ(ego.changed(messageAt(9.9)), messageAt(9.9));
  EXPECT_EQ(ego.changed(messageAt(10.0)), messageAt(10.0));
  const auto later = ego.changed(messageAt(10.5));
  EXPECT_EQ(later.transforms[1], messageAt(10.5).transforms[1]);
  const auto& base = later.transforms[0].transform;
  EXPECT_DOUBLE_EQ(base.translation.x, 7.0 - 1.5);
  EXPECT_DOUBLE_EQ(base.translation.y, 1.0 + 4.0 * 0.5 - 2.0 * 0.25);
  EXPECT_DOUBLE_EQ(base.translation.z, 1.0);
  EXPECT_NEAR(ego.changed(messageAt(20.0)).transforms[0].transform.translation.y, 3.0, 1e-9);
}

TEST(PostCrashEgo, KeepsRollAndPitchAndTurnsToTheHeadingAtTheContact) {
  constexpr double kRoll = 0.2;
  PostCrashEgo ego(sideways({0.0, 0.0, M_PI / 2}), 0.0);
  auto rolled = messageAt(9.9);
  rolled.transforms[0].transform.rotation.x = std::sin(kRoll / 2.0);
  rolled.transforms[0].transform.rotation.w = std::cos(kRoll / 2.0);
  ego.changed(rolled);
  const auto rotation = ego.changed(messageAt(10.5)).transforms[0].transform.rotation;
  // A quarter turn about z after the roll about x: the product of the two quaternions.
  EXPECT_NEAR(rotation.w, std::sqrt(0.5) * std::cos(kRoll / 2.0), 1e-9);
  EXPECT_NEAR(rotation.x, std::sqrt(0.5) * std::sin(kRoll / 2.0), 1e-9);
  EXPECT_NEAR(rotation.y, std::sqrt(0.5) * std::sin(kRoll / 2.0), 1e-9);
  EXPECT_NEAR(rotation.z, std::sqrt(0.5) * std::cos(kRoll / 2.0), 1e-9);
}

TEST(PostCrashEgo, OdometryHasTheVelocityInBaseLink) {
  PostCrashEgo ego(sideways({0.0, 0.0, M_PI / 2}), 0.0);
  nav_msgs::Odometry message;
  message.header.stamp = ros::Time(10.5);
  message.pose.pose.orientation.w = 1.0;
  message.twist.twist.linear.y = 3.0;
  message.twist.twist.angular.z = 0.5;
  const auto changed = ego.changed(message);
  EXPECT_NEAR(changed.twist.twist.linear.x, 2.0, 1e-9);  // +y of the map is ahead
  EXPECT_NEAR(changed.twist.twist.linear.y, 0.0, 1e-9);
  EXPECT_EQ(changed.twist.twist.angular.z, 0.0);
  EXPECT_DOUBLE_EQ(changed.pose.pose.position.y, 1.5);
}

TEST(PostCrashEgo, AddsOneMessageAtTheContact) {
  PostCrashEgo ego(sideways({7.0, 1.0, M_PI / 2}), 1.5);
  EXPECT_FALSE(ego.atContact(messageAt(10.3))) << "nothing before tells of its height";
  ego.changed(messageAt(9.9));
  EXPECT_FALSE(ego.atContact(messageAt(9.95)));
  const auto made = ego.atContact(messageAt(10.3));
  ASSERT_TRUE(made);
  EXPECT_NEAR(made->ratio, 0.25, 1e-9);
  ASSERT_EQ(made->message.transforms.size(), 1u);
  const auto& base = made->message.transforms.front();
  EXPECT_EQ(base.header.stamp, ros::Time(10.0));
  EXPECT_EQ(base.child_frame_id, names::kBaseFrame);
  EXPECT_NEAR(base.transform.translation.x, 7.0, 1e-9);
  EXPECT_NEAR(base.transform.translation.y, 1.0 - 1.5, 1e-9);
  EXPECT_NEAR(base.transform.translation.z, 0.99, 1e-9);
  EXPECT_NEAR(base.transform.rotation.z, std::sqrt(0.5), 1e-9);
  ego.changed(messageAt(10.3));
  EXPECT_FALSE(ego.atContact(messageAt(10.6)));
}

}  // namespace
}  // namespace forge
