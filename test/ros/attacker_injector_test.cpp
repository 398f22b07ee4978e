#include <gtest/gtest.h>

#include "collision_forge/ros/injection.h"

namespace forge {
namespace {

collision_forge::AttackerTrajectory trajectory() {
  collision_forge::AttackerTrajectory message;
  message.attacker_id = "a";
  message.size.x = 4.5;
  message.size.y = 2.0;
  for (int i = 0; i <= 10; ++i) {
    message.points.emplace_back();
    message.points.back().stamp = ros::Time(10.0 + 0.1 * i);
    message.points.back().pose.position.x = i;
    message.points.back().pose.orientation.w = 1.0;
    message.points.back().speed = 10.0;
  }
  return message;
}

/// A frame with the attacker at y = 3, and somebody else.
collision_forge::AgentArray frame(double time, double height) {
  collision_forge::AgentArray message;
  message.header.stamp = ros::Time(time);
  for (const char* id : {"other", "a"}) {
    message.agents.emplace_back();
    collision_forge::Agent& agent = message.agents.back();
    agent.id = id;
    agent.size.x = 5.0;
    agent.size.z = height;
    agent.pose.position.y = 3.0;
    agent.pose.position.z = 0.5 * height;
    agent.pose.orientation.w = 1.0;
  }
  return message;
}

TEST(AttackerInjector, TheAttackerDrivesItsTrajectoryAndIsGoneAfterwards) {
  AttackerInjector injector(trajectory());
  EXPECT_EQ(injector.inject(frame(10.0, 1.6)), frame(10.0, 1.6));
  const auto injected = injector.inject(frame(10.5, 1.7));
  EXPECT_EQ(injected.agents[0], frame(10.5, 1.7).agents[0]);
  EXPECT_EQ(injected.agents[1].pose.position.x, 5.0);
  EXPECT_EQ(injected.agents[1].pose.position.y, 0.0);
  EXPECT_EQ(injected.agents[1].velocity.x, 10.0);
  EXPECT_EQ(injected.agents[1].size.z, 1.6);
  const auto after = injector.inject(frame(11.1, 1.6));
  ASSERT_EQ(after.agents.size(), 1u);
  EXPECT_EQ(after.agents[0].id, "other");
}

TEST(AttackerInjector, OneThatStartsLateTakesTheHeightFromTheFirstFrameThatHasIt) {
  AttackerInjector injector(trajectory());
  auto without = frame(10.2, 1.6);
  without.agents.pop_back();
  EXPECT_EQ(injector.inject(without).agents[1].size.z, 0.0);
  for (const double height : {1.6, 1.7}) {
    const auto injected = injector.inject(frame(10.5, height));
    EXPECT_EQ(injected.agents[1].size.z, 1.6);
    EXPECT_EQ(injected.agents[1].pose.position.z, 0.8);
    EXPECT_EQ(injected.agents[1].pose.position.x, 5.0);
  }
}

}  // namespace
}  // namespace forge
