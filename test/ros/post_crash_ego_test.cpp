#include "collision_forge/ros/injection/post_crash_ego.h"

#include <gtest/gtest.h>

#include <cmath>

#include "collision_forge/planner_test/settings/config.h"
#include "collision_forge/ros/messages/topic_names.h"

namespace forge {
namespace {

const SeverityOptions& severity() {
  static const Config config = loadConfig(COLLISION_FORGE_SOURCE_DIR "/config");
  return config.attack.verification.severity;
}

/// The ego stands at `box` and is hit at 10 s by a car that drives along y, behind its centre if
/// its yaw is 0.
PostCrashMotion hitFromTheRight(const Pose2& box) {
  const CrashedVehicle ego{AgentClass::kCar, {4.0, 2.0}, {10.0, box, {0.0, 0.0}}};
  const CrashedVehicle attacker{
      AgentClass::kCar, {4.0, 2.0}, {10.0, {box.x - 1.0, box.y - 3.0, M_PI / 2}, {0.0, 8.0}}};
  return {ego, attacker, severity()};
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
  const PostCrashMotion crash = hitFromTheRight({7.0, 1.0, 0.0});
  PostCrashEgo ego(crash, 1.5);
  EXPECT_EQ(ego.changed(messageAt(9.9)), messageAt(9.9));
  EXPECT_EQ(ego.changed(messageAt(10.0)), messageAt(10.0));
  const auto later = ego.changed(messageAt(10.5));
  EXPECT_EQ(later.transforms[1], messageAt(10.5).transforms[1]);
  const auto& base = later.transforms[0].transform;
  const Pose2 expected = compose(crash.egoAt(10.5).pose, {-1.5, 0.0, 0.0});
  EXPECT_GT(expected.y, 1.5) << "pushed to the left";
  EXPECT_NEAR(base.translation.x, expected.x, 1e-9);
  EXPECT_NEAR(base.translation.y, expected.y, 1e-9);
  EXPECT_DOUBLE_EQ(base.translation.z, 1.0);
}

TEST(PostCrashEgo, KeepsRollAndPitchAndTurnsToTheHeadingAtTheContact) {
  constexpr double kRoll = 0.2;
  const PostCrashMotion crash = hitFromTheRight({0.0, 0.0, 0.0});
  PostCrashEgo ego(crash, 0.0);
  auto rolled = messageAt(9.9);
  rolled.transforms[0].transform.rotation.x = std::sin(kRoll / 2.0);
  rolled.transforms[0].transform.rotation.w = std::cos(kRoll / 2.0);
  ego.changed(rolled);
  const auto rotation = ego.changed(messageAt(10.5)).transforms[0].transform.rotation;
  // The turn about z after the roll about x: the product of the two quaternions.
  const double half = 0.5 * crash.egoAt(10.5).pose.yaw;
  EXPECT_LT(half, -0.1) << "hit behind its centre";
  EXPECT_NEAR(rotation.w, std::cos(half) * std::cos(kRoll / 2.0), 1e-9);
  EXPECT_NEAR(rotation.x, std::cos(half) * std::sin(kRoll / 2.0), 1e-9);
  EXPECT_NEAR(rotation.y, std::sin(half) * std::sin(kRoll / 2.0), 1e-9);
  EXPECT_NEAR(rotation.z, std::sin(half) * std::cos(kRoll / 2.0), 1e-9);
}

TEST(PostCrashEgo, OdometryHasTheVelocityInBaseLink) {
  const PostCrashMotion crash = hitFromTheRight({0.0, 0.0, 0.0});
  PostCrashEgo ego(crash, 0.0);
  nav_msgs::Odometry message;
  message.header.stamp = ros::Time(10.5);
  message.pose.pose.orientation.w = 1.0;
  message.twist.twist.linear.y = 3.0;
  message.twist.twist.angular.z = 0.5;
  const auto changed = ego.changed(message);
  const AgentState expected = crash.egoAt(10.5);
  const double turned = angleBetween(expected.pose.yaw, crash.egoAt(10.501).pose.yaw);
  EXPECT_LT(turned, 0.0);
  EXPECT_NEAR(changed.twist.twist.angular.z, turned / 0.001, 0.05);
  const Vector2 ahead = expected.pose.heading();
  EXPECT_NEAR(changed.twist.twist.linear.x, expected.velocity.dot(ahead), 1e-9);
  EXPECT_NEAR(changed.twist.twist.linear.y, expected.velocity.dot(Vector2(-ahead.y(), ahead.x())),
              1e-9);
  EXPECT_NEAR(changed.pose.pose.position.y, expected.pose.y, 1e-9);
}

TEST(PostCrashEgo, AddsOneMessageAtTheContact) {
  PostCrashEgo ego(hitFromTheRight({7.0, 1.0, M_PI / 2}), 1.5);
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
