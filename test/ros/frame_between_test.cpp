#include "collision_forge/ros/injection/frame_between.h"

#include <gtest/gtest.h>

#include <cmath>

namespace forge {
namespace {

collision_forge::Agent agent(const std::string& id, double x, double yaw) {
  collision_forge::Agent agent;
  agent.id = id;
  agent.size.x = 4.0;
  agent.pose.position.x = x;
  agent.pose.position.z = x / 10.0;
  agent.pose.orientation.z = std::sin(yaw / 2.0);
  agent.pose.orientation.w = std::cos(yaw / 2.0);
  agent.velocity.x = x;
  return agent;
}

TEST(FrameBetween, InterpolatesTheAgentsInBothFrames) {
  collision_forge::AgentArray before;
  before.header.stamp = ros::Time(10.0);
  before.header.frame_id = "map";
  before.agents = {agent("leaves", 0.0, 0.0), agent("stays", 10.0, 3.0)};
  collision_forge::AgentArray after = before;
  after.header.stamp = ros::Time(10.5);
  after.agents = {agent("stays", 20.0, -3.0), agent("comes", 0.0, 0.0)};
  const auto frame = frameBetween(before, after, 0.25);
  EXPECT_EQ(frame.header.stamp, ros::Time(10.125));
  EXPECT_EQ(frame.header.frame_id, "map");
  ASSERT_EQ(frame.agents.size(), 1u);
  const auto& between = frame.agents.front();
  EXPECT_EQ(between.id, "stays");
  EXPECT_EQ(between.size.x, 4.0);
  EXPECT_DOUBLE_EQ(between.pose.position.x, 12.5);
  EXPECT_DOUBLE_EQ(between.pose.position.z, 1.25);
  EXPECT_DOUBLE_EQ(between.velocity.x, 12.5);
  // From 3 rad on by 2 pi - 6 the shorter way, over pi.
  const double yaw = 2.0 * std::atan2(between.pose.orientation.z, between.pose.orientation.w);
  EXPECT_NEAR(std::remainder(yaw - (3.0 + 0.25 * (2.0 * M_PI - 6.0)), 2.0 * M_PI), 0.0, 1e-9);
}

TEST(FrameAfter, ExtrapolatesTheAgentsOfTheNewestFrameWithTheirTurnRates) {
  collision_forge::AgentArray before;
  before.header.stamp = ros::Time(10.0);
  before.agents = {agent("turns", 0.0, 0.0), agent("leaves", 0.0, 0.0)};
  collision_forge::AgentArray newest;
  newest.header.stamp = ros::Time(10.5);
  newest.agents = {agent("comes", 7.0, 1.0), agent("turns", 4.0, 0.1)};
  const auto frame = frameAfter(&before, newest, ros::Time(10.7));
  EXPECT_EQ(frame.header.stamp, ros::Time(10.7));
  ASSERT_EQ(frame.agents.size(), 2u);
  EXPECT_NEAR(frame.agents[0].pose.position.x, 7.0, 1e-9);
  EXPECT_NEAR(frame.agents[0].pose.orientation.z, newest.agents[0].pose.orientation.z, 1e-9);
  // 8 m/s eastwards, turning at 0.2 rad/s: a circle with a radius of 40 m.
  const auto& moved = frame.agents[1];
  EXPECT_NEAR(moved.pose.position.x, 4.0 + 40.0 * std::sin(0.04), 1e-6);
  EXPECT_NEAR(moved.pose.position.y, 40.0 * (1.0 - std::cos(0.04)), 1e-6);
  EXPECT_NEAR(moved.pose.position.z, newest.agents[1].pose.position.z, 1e-9);
  EXPECT_NEAR(2.0 * std::atan2(moved.pose.orientation.z, moved.pose.orientation.w), 0.14, 1e-6);
  EXPECT_NEAR(std::atan2(moved.velocity.y, moved.velocity.x), 0.04, 1e-6);
}

}  // namespace
}  // namespace forge
