#include "collision_forge/planner_test/planners/idm.h"

#include <gtest/gtest.h>

#include "planner_test/trials/rollout_scenes.h"

namespace forge {
namespace {

DrivingTask straightTask() {
  return {std::make_shared<const LaneIndex>(twoLaneRoad()),
          {{-50.0, 0.0}, {150.0, 0.0}},
          {kEgoSize, 1.385},
          2.588};
}

TrajectoryPoint egoAt(double speed) { return {kNow, {0.0, 0.0, 0.0}, speed, 0.0, 0.0}; }

const IdmOptions& standard() { return shippedConfig().planners.idm; }
const PublishedIdmOptions& published() { return shippedConfig().planners.published_idm; }

const RouteCenterlineOptions& routeOptions() { return shippedConfig().planners.route_centerline; }

std::vector<TrajectoryPoint> planStandard(double speed, const std::vector<Track>& agents) {
  IdmPlanner planner(standard(), routeOptions());
  planner.initialize(straightTask());
  return planner.plan({egoAt(speed), agents});
}

TEST(IdmPlanner, StartsAtTheEgoAndLastsTheHorizon) {
  const auto plan = planStandard(5.0, {});
  ASSERT_EQ(plan.size(), 17u);
  EXPECT_EQ(plan.front().time, kNow);
  EXPECT_NEAR(plan.back().time, kNow + standard().horizon, 1e-9);
}

TEST(IdmPlanner, StartsOnThePathBesideTheEgo) {
  IdmPlanner planner(standard(), routeOptions());
  planner.initialize(straightTask());
  const auto plan = planner.plan({{kNow, {0.0, 0.5, 0.1}, 5.0, 0.0, 0.0}, {}});
  EXPECT_NEAR(plan.front().pose.y, 0.0, 1e-9);
  EXPECT_NEAR(plan.front().pose.yaw, 0.0, 1e-9);
}

TEST(IdmPlanner, IgnoresAgentsBesideTheCorridorOrFarAway) {
  const auto free = planStandard(5.0, {});
  const auto plan = planStandard(5.0, {pastTrack("beside", kCarSize, {15.0, 3.5, 0.0}, 0.0),
                                       pastTrack("behind", kCarSize, {-8.0, 0.0, 0.0}, 9.0),
                                       pastTrack("far", kCarSize, {41.0, 0.0, 0.0}, 0.0)});
  EXPECT_EQ(plan.back().pose.x, free.back().pose.x);
}

TEST(IdmPlanner, StopsBehindAStandingLead) {
  const auto plan = planStandard(5.0, {pastTrack("lead", kCarSize, {25.0, 0.0, 0.0}, 0.0)});
  const double bumper = 25.0 - 0.5 * (kEgoSize.length + kCarSize.length);
  EXPECT_LT(plan.back().speed, 0.5);
  EXPECT_LT(plan.back().pose.x, bumper);
  EXPECT_GT(plan.back().pose.x, bumper - 5.0);
}

TEST(IdmPlanner, DesiredSpeedIsTheHigherOfSpeedLimitAndEgoSpeed) {
  const auto targetAt = [](double speed, std::optional<double> limit) {
    auto map = twoLaneRoad();
    for (Lane& lane : map->lanes) lane.speed_limit = limit;
    DrivingTask task = straightTask();
    task.lanes = std::make_shared<const LaneIndex>(map);
    IdmPlanner planner(standard(), routeOptions());
    planner.initialize(task);
    planner.plan({egoAt(speed), {}});
    return planner.targetSpeed();
  };
  EXPECT_EQ(targetAt(5.0, std::nullopt), standard().law.desired_speed);
  EXPECT_EQ(targetAt(12.0, std::nullopt), 12.0);
  EXPECT_EQ(targetAt(5.0, 8.0), 8.0);
  EXPECT_EQ(targetAt(9.0, 8.0), 9.0);
}

TEST(IdmPlanner, FollowsItsRouteBeyondTheEndOfItsLanes) {
  auto map = emptyMap();
  map->lanes = {straightLane("ends", {-50, 0}, {20, 0}),
                straightLane("beside", {-50, 3.5}, {150, 3.5})};
  DrivingTask task = straightTask();
  task.lanes = std::make_shared<const LaneIndex>(map);
  task.route = {{-50.0, 0.0}, {10.0, 0.0}, {30.0, 3.5}, {150.0, 3.5}};
  IdmPlanner planner(standard(), routeOptions());
  planner.initialize(task);
  const auto plan = planner.plan({egoAt(10.0), {}});
  EXPECT_GT(plan.back().pose.x, 60.0);
  EXPECT_NEAR(plan.back().pose.y, 3.5, 0.1);
}

TEST(IdmPlanner, FollowsItsRouteWhereNoLaneIsNear) {
  DrivingTask task = straightTask();
  task.route = {{0.0, 60.0}, {0.0, 160.0}};
  IdmPlanner planner(standard(), routeOptions());
  planner.initialize(task);
  const auto plan = planner.plan({{kNow, {0.0, 60.0, M_PI_2}, 5.0, 0.0, 0.0}, {}});
  EXPECT_NEAR(plan.back().pose.x, 0.0, 1e-9);
  EXPECT_GT(plan.back().pose.y, 90.0);
}

TrajectoryPoint planPublished(double speed, const std::vector<Track>& agents) {
  PublishedIdmPlanner planner(published(), "attacker");
  planner.initialize(straightTask());
  return planner.plan({egoAt(speed), agents}).back();
}

/// Integrates the law over one step in 10,000 small ones behind a standing lead.
double finelyIntegrated(double speed, double lead_speed, double distance) {
  constexpr int kSteps = 10000;
  const double step = published().step / kSteps;
  for (int i = 0; i < kSteps; ++i) {
    const double acceleration = plainIdmAcceleration(published().law, speed, lead_speed, distance);
    distance -= speed * step;
    speed += acceleration * step;
  }
  return speed;
}

TEST(PublishedIdmPlanner, UsesTheAttackerAsLeadAtCentreDistanceInAnyDirection) {
  const double expected = finelyIntegrated(4.0, 3.0, 10.0);
  for (const double x : {10.0, -10.0}) {
    const auto point = planPublished(4.0, {pastTrack("attacker", kCarSize, {x, 0.0, 0.0}, 3.0)});
    EXPECT_NEAR(point.speed, expected, 1e-3) << x;
    EXPECT_NEAR(point.pose.x, published().step * point.speed, 1e-9) << x;
  }
}

TEST(PublishedIdmPlanner, IgnoresOtherAgents) {
  const auto free = planPublished(4.0, {});
  EXPECT_NEAR(free.speed, finelyIntegrated(4.0, 0.0, HUGE_VAL), 1e-3);
  const auto other = planPublished(4.0, {pastTrack("other", kCarSize, {10.0, 0.0, 0.0}, 0.0)});
  EXPECT_EQ(other.speed, free.speed);
}

}  // namespace
}  // namespace forge
