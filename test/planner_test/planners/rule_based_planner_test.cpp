#include "collision_forge/planner_test/planners/rule_based_planner.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "planner_test/planners/planner_scenes.h"

namespace forge {
namespace {

const RuleBasedOptions& published() { return shippedConfig().planners.rule_based; }

/// A road east along y = 0, crossed by one from the south at x = 60.
std::shared_ptr<const LaneIndex> crossing() {
  auto map = std::make_shared<LaneMap>();
  map->lanes = {outlinedLane("east", {-100.0, 0.0}, {300.0, 0.0}),
                outlinedLane("north", {60.0, -150.0}, {60.0, 150.0})};
  return std::make_shared<const LaneIndex>(map);
}

/// Simulates the ego for `seconds`, one state per planning step; other agents drive straight on.
std::vector<TrajectoryPoint> drive(std::shared_ptr<const LaneIndex> lanes, TrajectoryPoint ego,
                                   std::vector<Track> agents, double seconds,
                                   const RuleBasedOptions& options = published()) {
  RuleBasedPlanner planner(options);
  planner.initialize(taskOn(std::move(lanes)));
  std::vector<TrajectoryPoint> driven = {ego};
  while (ego.time < seconds) {
    ego = planner.plan({ego, agents})[1];
    for (Track& agent : agents) {
      AgentState next = agent.states.back();
      next.time = ego.time;
      next.pose.x += options.step * next.velocity.x();
      next.pose.y += options.step * next.velocity.y();
      agent.states.push_back(next);
    }
    driven.push_back(ego);
  }
  return driven;
}

/// Returns the smallest distance between the ego's box and the agent's, which drives straight on
/// from time 0.
double closest(const std::vector<TrajectoryPoint>& driven, const Track& agent) {
  double least = 1e9;
  for (const TrajectoryPoint& point : driven) {
    Pose2 there = agent.states.front().pose;
    there.x += point.time * agent.states.front().velocity.x();
    there.y += point.time * agent.states.front().velocity.y();
    least = std::min(least,
                     distance({point.pose, shippedConfig().ego_vehicle.size}, boxAt(agent, there)));
  }
  return least;
}

TEST(RuleBasedPlanner, PlansFiveSecondsInSteps) {
  RuleBasedPlanner planner(published());
  planner.initialize(taskOn(crossing()));
  const std::vector<TrajectoryPoint> points = planner.plan({egoAt({0.0, 0.5, 0.0}, 8.0), {}});
  const std::vector<WeighedProfile>& profiles = planner.choice().profiles;
  const std::vector<std::vector<Pose2>> proposals = planner.proposals();
  ASSERT_EQ(proposals.size(), profiles.size());
  for (std::size_t i = 0; i < proposals.size(); ++i) {
    ASSERT_EQ(proposals[i].size(), 26U);
    EXPECT_EQ(proposals[i].front().y, 0.5);
    // The path bends back into the lane, which costs some of its length.
    EXPECT_NEAR(proposals[i].back().x, profiles[i].profile.plan.distances.back(), 0.05);
  }
  ASSERT_EQ(points.size(), 26U);
  EXPECT_EQ(points.front().time, 0.0);
  EXPECT_NEAR(points.back().time, 5.0, 1e-9);
  EXPECT_EQ(points.front().pose.y, 0.5);
  for (const TrajectoryPoint& point : points) {
    EXPECT_LE(std::abs(point.acceleration), published().max_acceleration + 1e-9);
  }
}

TEST(RuleBasedPlanner, StopsForACrossingCarInRange) {
  // A slow and long vehicle blocks the ego's path from 1 to 15 s; the ego would arrive after 5 s.
  const Track car = agentAt("a", {60.0, -8.0, 0.5 * M_PI}, 1.0, {12.0, 2.5});
  const auto driven = drive(crossing(), egoAt({20.0, 0.0, 0.0}, 8.0), {car}, 22.0);
  EXPECT_GT(closest(driven, car), 0.3);
  double slowest = 100.0;
  for (const TrajectoryPoint& point : driven) slowest = std::min(slowest, point.speed);
  EXPECT_LT(slowest, 1.0);
  EXPECT_GT(driven.back().pose.x, 65.0);
}

TEST(RuleBasedPlanner, PassesTrafficTwoLanesAwayButNotInTheNext) {
  // A gap of 1.7 m is too risky for long, one of 5.2 m is not.
  const auto lanes = threeLaneRoad();
  const Track oncoming = agentAt("oncoming", {90.0, 7.0, M_PI}, 10.0);
  const auto passed = drive(lanes, egoAt({0.0, 0.0, 0.0}, 10.0), {oncoming}, 8.0);
  EXPECT_GT(passed.back().pose.x, 90.0);
  const Track beside = agentAt("beside", {30.0, 3.5, 0.0}, 5.0);
  const auto followed = drive(lanes, egoAt({0.0, 0.0, 0.0}, 10.0), {beside}, 8.0);
  EXPECT_LT(followed.back().pose.x, 30.0 + 5.0 * 8.0);
}

TEST(RuleBasedPlanner, FollowsABend) {
  const auto driven = drive(bentRoad(30.0), egoAt({-40.0, 0.5, 0.0}, 6.0), {}, 10.0);
  for (const TrajectoryPoint& point : driven) {
    const Vector2 place = point.pose.position();
    if (place.x() > 0.0 && place.y() < 30.0) {
      EXPECT_NEAR((place - Vector2(0.0, 30.0)).norm(), 30.0, 0.5);
    }
  }
  EXPECT_GT(driven.back().pose.y, 40.0);
  EXPECT_NEAR(driven.back().pose.x, 30.0, 0.3);
  EXPECT_NEAR(driven.back().pose.yaw, 0.5 * M_PI, 0.05);
}

TEST(RuleBasedPlanner, TheTunedParametersKeepMoreDistance) {
  const Track car = agentAt("a", {60.0, 0.0, 0.5 * M_PI}, 0.0);
  const auto driven = drive(crossing(), egoAt({0.0, 0.0, 0.0}, 10.0), {car}, 15.0);
  const auto tuned = drive(crossing(), egoAt({0.0, 0.0, 0.0}, 10.0), {car}, 15.0,
                           shippedConfig().planners.tuned_rule_based);
  EXPECT_GT(closest(tuned, car), closest(driven, car));
  EXPECT_NEAR(drive(crossing(), egoAt({0.0, 0.0, 0.0}, 8.0), {}, 8.0,
                    shippedConfig().planners.tuned_rule_based)
                  .back()
                  .speed,
              20.0, 0.5);
}

TEST(RuleBasedPlanner, FollowsTheRouteOnlyWithAlongRoute) {
  auto map = std::make_shared<LaneMap>();
  map->lanes = {outlinedLane("in", {-50.0, 0.0}, {20.0, 0.0}, {"straight", "left"}),
                outlinedLane("straight", {20.0, 0.0}, {220.0, 0.0}),
                outlinedLane("left", {20.0, 0.0}, {160.0, 140.0})};
  DrivingTask task = taskOn(std::make_shared<const LaneIndex>(map));
  task.route = {{-50.0, 0.0}, {20.0, 0.0}, {160.0, 140.0}};
  RuleBasedOptions options = published();
  for (const EgoWay way : {EgoWay::kFirst, EgoWay::kAlongRoute}) {
    options.ego_way = way;
    RuleBasedPlanner planner(options);
    planner.initialize(task);
    const auto points = planner.plan({egoAt({0.0, 0.0, 0.0}, 10.0), {}});
    EXPECT_EQ(points.back().pose.y > 5.0, way == EgoWay::kAlongRoute);
  }
}

TEST(RuleBasedPlanner, RejectsATaskWithoutLanesOrRoute) {
  RuleBasedPlanner planner(published());
  EXPECT_THROW(planner.initialize({}), std::invalid_argument);
  DrivingTask task = taskOn(crossing());
  task.route.clear();
  EXPECT_THROW(planner.initialize(task), std::invalid_argument);
}

}  // namespace
}  // namespace forge
