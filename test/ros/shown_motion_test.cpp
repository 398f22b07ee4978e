#include "collision_forge/ros/markers/shown_motion.h"

#include <gtest/gtest.h>

#include "collision_forge/base/scene/scene.h"

namespace forge {
namespace {

collision_forge::AgentTrack turning(double speed) {
  collision_forge::AgentTrack track;
  track.states.resize(2);
  track.states[0].stamp = ros::Time(9.5);
  track.states[1].stamp = ros::Time(10.0);
  track.states[1].pose.theta = 0.1;
  track.states[1].velocity_x = speed;
  return track;
}

TEST(ShownMotion, IntegratesATurnExactly) {
  const AgentState start{0.0, {1.0, 2.0, 0.3}, {6.0, 2.0}};
  const double rate = 0.7;
  AgentState step = start;
  for (int i = 0; i < 60000; ++i) {
    step.pose = {step.pose.x + step.velocity.x() * 1e-5, step.pose.y + step.velocity.y() * 1e-5,
                 step.pose.yaw + rate * 1e-5};
    const Vector2 velocity = step.velocity;
    step.velocity += rate * 1e-5 * Vector2(-velocity.y(), velocity.x());
  }
  const Pose2 moved = movedOn(start, rate, 0.6);
  EXPECT_NEAR(moved.x, step.pose.x, 1e-3);
  EXPECT_NEAR(moved.y, step.pose.y, 1e-3);
  EXPECT_NEAR(moved.yaw, step.pose.yaw, 1e-9);
}

TEST(ShownMotion, InterpolatesPosesAndExtrapolatesForALimitedTime) {
  const Track poses{kEgoId,
                    AgentClass::kCar,
                    {4.0, 2.0},
                    {{10.0, {0.0, 0.0, 0.0}, {5.0, 0.0}}, {10.1, {0.5, 0.0, 0.0}, {5.0, 0.0}}}};
  EXPECT_FALSE(shownState(poses, 9.9));
  EXPECT_NEAR(shownState(poses, 10.05)->pose.x, 0.25, 1e-9);
  EXPECT_NEAR(shownState(poses, 10.3)->pose.x, 1.5, 1e-9);
  EXPECT_EQ(shownState(poses, 10.3)->time, 10.3);
  EXPECT_FALSE(shownState(poses, 10.1 + kLongestGuess + 0.1)) << "nobody knows";
  EXPECT_FALSE(shownState({}, 10.0));
}

TEST(ShownMotion, ExtrapolatesTheNewestFrameForALimitedTime) {
  auto track = turning(5.0);
  track.states[0].pose.theta = 0.1;
  EXPECT_NEAR(shownPose(track, ros::Time(10.2)).x, 1.0, 1e-6);
  EXPECT_NEAR(shownPose(track, ros::Time(20.0)).x, 5.0 * kLongestGuess, 1e-6);
  EXPECT_NEAR(shownPose(track, ros::Time(9.0)).x, 0.0, 1e-6);
}

TEST(ShownMotion, FollowsTheTrajectoryOfAnAttacker) {
  collision_forge::AttackerTrajectory trajectory;
  EXPECT_FALSE(drivenPose(trajectory, ros::Time(10.0)));
  trajectory.points.resize(2);
  trajectory.points[0].stamp = ros::Time(10.0);
  trajectory.points[1].stamp = ros::Time(11.0);
  trajectory.points[1].pose.position.x = 8.0;
  trajectory.points[0].pose.orientation.w = trajectory.points[1].pose.orientation.w = 1.0;
  EXPECT_FALSE(drivenPose(trajectory, ros::Time(9.9)));
  EXPECT_NEAR(drivenPose(trajectory, ros::Time(10.25))->x, 2.0, 1e-6);
  EXPECT_NEAR(drivenPose(trajectory, ros::Time(12.0))->x, 8.0, 1e-6);
}

}  // namespace
}  // namespace forge
