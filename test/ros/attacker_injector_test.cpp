#include "collision_forge/ros/injection/attacker_injector.h"

#include <gtest/gtest.h>

#include "collision_forge/planner_test/settings/config.h"

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

/// Every vehicle brakes with 5 m/s2.
DriveLimitOptions limits() {
  DriveLimitOptions options =
      loadConfig(COLLISION_FORGE_SOURCE_DIR "/config").attack.verification.drivable;
  for (DriveLimits& row : options.rows) row.max_braking = 5.0;
  return options;
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

TEST(AttackerInjector, TheAttackerDrivesItsTrajectoryAndThenBrakesToAStandstill) {
  AttackerInjector injector(trajectory(), limits());
  EXPECT_EQ(injector.inject(frame(10.0, 1.6)), frame(10.0, 1.6));
  const auto injected = injector.inject(frame(10.5, 1.7));
  EXPECT_EQ(injected.agents[0], frame(10.5, 1.7).agents[0]);
  EXPECT_EQ(injected.agents[1].pose.position.x, 5.0);
  EXPECT_EQ(injected.agents[1].pose.position.y, 0.0);
  EXPECT_EQ(injected.agents[1].velocity.x, 10.0);
  EXPECT_EQ(injected.agents[1].size.z, 1.6);
  for (const double time : {13.0, 100.0}) {  // it stands after 2 s and 10 m
    const auto after = injector.inject(frame(time, 1.6));
    ASSERT_EQ(after.agents.size(), 2u);
    EXPECT_EQ(after.agents[0], frame(time, 1.6).agents[0]);
    EXPECT_NEAR(after.agents[1].pose.position.x, 20.0, 1e-9);
    EXPECT_NEAR(after.agents[1].velocity.x, 0.0, 1e-9);
  }
}

TEST(AttackerInjector, AnAttackerRecordedTwiceAppearsOnce) {
  AttackerInjector injector(trajectory(), limits());
  auto recorded = frame(10.5, 1.6);
  recorded.agents.push_back(recorded.agents[1]);
  EXPECT_EQ(injector.inject(recorded).agents.size(), 2u);
}

/// Nobody recorded it: at x = -10 at 9 s, -5 at 9.5 s, 0 at 10 s.
collision_forge::AttackerTrajectory addedTrajectory() {
  collision_forge::AttackerTrajectory message = trajectory();
  message.attacker_id = "new";
  message.agent_class = collision_forge::Agent::TRUCK;
  message.added = true;
  for (int i = 0; i <= 2; ++i) {
    message.past.emplace_back();
    message.past.back().stamp = ros::Time(9.0 + 0.5 * i);
    message.past.back().pose.x = -10.0 + 5.0 * i;
    message.past.back().velocity_x = 10.0;
  }
  return message;
}

TEST(AttackerInjector, AnAddedAttackerIsANewAgentFromItsFirstStateOn) {
  AttackerInjector injector(addedTrajectory(), limits());
  EXPECT_EQ(injector.inject(frame(8.5, 1.6)), frame(8.5, 1.6));
  double x = -10.0;
  for (const double time : {9.0, 9.5, 10.0, 10.5}) {
    const auto injected = injector.inject(frame(time, 1.6));
    ASSERT_EQ(injected.agents.size(), 3u);
    EXPECT_EQ(injected.agents[0], frame(time, 1.6).agents[0]);
    EXPECT_EQ(injected.agents[1], frame(time, 1.6).agents[1]);
    const collision_forge::Agent& added = injected.agents[2];
    EXPECT_EQ(added.id, "new");
    EXPECT_EQ(added.agent_class, collision_forge::Agent::TRUCK);
    EXPECT_EQ(added.size.x, 4.5);
    EXPECT_EQ(added.pose.position.x, x);
    EXPECT_EQ(added.velocity.x, 10.0);
    x += 5.0;
  }
}

TEST(AttackerInjector, AnAddedAttackerHasTheHeightOfItsClassOnTheGroundOfItsNeighbour) {
  AttackerInjector injector(addedTrajectory(), limits());
  auto recorded = frame(10.0, 1.6);
  for (auto& agent : recorded.agents) {
    agent.agent_class = collision_forge::Agent::TRUCK;
    agent.pose.position.z += 3.0;
  }
  const collision_forge::Agent added = injector.inject(recorded).agents.at(2);
  const double height = typicalHeight(AgentClass::kTruck, {4.5, 2.0});
  EXPECT_EQ(added.size.z, height);
  EXPECT_NEAR(added.pose.position.z, 3.0 + 0.5 * height, 1e-9);
}

TEST(AttackerInjector, ARecordedAttackerHasTheClassOfItsTrajectory) {
  auto running = trajectory();
  running.agent_class = collision_forge::Agent::RUNNER;
  AttackerInjector injector(running, limits());
  auto recorded = frame(10.0, 1.8);
  recorded.agents[1].agent_class = collision_forge::Agent::PEDESTRIAN;
  injector.remember(recorded);
  recorded.header.stamp = ros::Time(10.5);
  const collision_forge::Agent attacker = injector.inject(recorded).agents.at(1);
  EXPECT_EQ(attacker.agent_class, collision_forge::Agent::RUNNER);
  EXPECT_EQ(attacker.size.z, 1.8);
}

TEST(AttackerInjector, ASupportThatDrivesAtItsLastPointLeavesThereAndOneThatStandsStays) {
  for (const double last_speed : {10.0, 0.0}) {
    auto motion = trajectory();
    motion.points.back().speed = last_speed;
    AttackerInjector injector(motion, limits(), AfterEnd::kLeave);
    EXPECT_EQ(injector.inject(frame(11.0, 1.6)).agents.size(), 2u) << "at the last point";
    const auto after = injector.inject(frame(11.5, 1.6)).agents;
    ASSERT_EQ(after.size(), last_speed == 0.0 ? 2u : 1u);
    EXPECT_EQ(after[0], frame(11.5, 1.6).agents[0]);
    if (last_speed == 0.0) {
      EXPECT_NEAR(after[1].pose.position.x, 10.0, 1e-9);
    }
  }
}

TEST(AttackerInjector, ThePostCrashMotionReplacesTheTrajectoryAtTheContact) {
  AttackerInjector injector(trajectory(), limits());
  const SeverityOptions severity =
      loadConfig(COLLISION_FORGE_SOURCE_DIR "/config").attack.verification.severity;
  const CrashedVehicle ego{AgentClass::kCar, {4.5, 2.0}, {10.5, {5.0, -3.25, 0.0}, {0.0, 0.0}}};
  const CrashedVehicle attacker{
      AgentClass::kCar, {4.5, 2.0}, {10.5, {5.0, 0.0, -M_PI / 2}, {0.0, -5.0}}};
  const PostCrashMotion crash(ego, attacker, severity);
  injector.setCrash(crash);
  EXPECT_EQ(injector.inject(frame(10.4, 1.6)).agents[1].pose.position.x, 4.0);
  for (const double time : {11.0, 20.0}) {
    const auto sliding = injector.inject(frame(time, 1.6)).agents[1];
    const AgentState expected = crash.attackerAt(time);
    EXPECT_NEAR(sliding.pose.position.x, expected.pose.x, 1e-9) << time;
    EXPECT_NEAR(sliding.pose.position.y, expected.pose.y, 1e-9) << time;
    EXPECT_NEAR(sliding.velocity.y, expected.velocity.y(), 1e-9) << time;
    EXPECT_LT(sliding.pose.position.y, -0.2) << "it goes on";
  }
  injector.setCrash(std::nullopt);
  EXPECT_EQ(injector.inject(frame(11.0, 1.6)).agents[1].pose.position.x, 10.0);
}

TEST(AttackerInjector, ATrajectoryOfAnotherAttackChangesNothing) {
  AttackerInjector injector(trajectory(), limits());
  auto of_another = trajectory();
  of_another.attacker_id = "other";
  auto later = trajectory();
  later.header.stamp = ros::Time(10.5);
  for (auto* changed : {&of_another, &later}) {
    for (auto& point : changed->points) point.pose.position.y = -2.0;
    EXPECT_FALSE(injector.change(*changed));
  }
  EXPECT_FALSE(injector.change(addedTrajectory()));
  EXPECT_EQ(injector.inject(frame(10.5, 1.6)).agents[1].pose.position.y, 0.0);
}

}  // namespace
}  // namespace forge
