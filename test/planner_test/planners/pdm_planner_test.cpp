#include "collision_forge/planner_test/planners/pdm_planner.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "planner_test/planners/planner_scenes.h"

namespace forge {
namespace {

PdmPlanner plannerOn(const DrivingTask& task) {
  const PlannerOptions& options = shippedConfig().planners;
  PdmPlanner planner(options.pdm, options.route_centerline, options.car, options.lqr);
  planner.initialize(task);
  return planner;
}

const PdmCandidate& best(const PdmPlanner& planner) {
  return planner.closed()->candidates()[planner.closed()->best()];
}

bool touchesAnybody(const std::vector<TrajectoryPoint>& points, const std::vector<Track>& agents) {
  for (const TrajectoryPoint& point : points) {
    for (const Track& agent : agents) {
      const AgentState& now = agent.states.back();
      Pose2 there = now.pose;
      there.x += now.velocity.x() * point.time;
      there.y += now.velocity.y() * point.time;
      if (overlaps({point.pose, shippedConfig().ego_vehicle.size}, boxAt(agent, there)))
        return true;
    }
  }
  return false;
}

TEST(PdmPlanner, ScoresFifteenProposalsAndPlansEightSeconds) {
  PdmPlanner planner = plannerOn(taskOn(threeLaneRoad()));
  const std::vector<TrajectoryPoint> points = planner.plan({egoAt({0.0, 0.3, 0.05}, 8.0), {}});
  EXPECT_EQ(planner.closed()->candidates().size(), 15U);
  EXPECT_EQ(planner.closed()->candidates().front().motion.states.size(), 41U);
  const std::vector<std::vector<Pose2>> proposals = planner.proposals();
  ASSERT_EQ(proposals.size(), 15U);
  for (const std::vector<Pose2>& proposal : proposals) {
    ASSERT_EQ(proposal.size(), 41U);
    EXPECT_NEAR(proposal.front().y, 0.3, 1e-9);  // the middle of the box, as the ego's
  }
  EXPECT_GT(proposals.back().back().x, proposals.front().back().x);
  ASSERT_EQ(points.size(), 81U);
  EXPECT_EQ(points.front().time, 0.0);
  EXPECT_NEAR(points.back().time, 8.0, 1e-9);
  // The plan has the poses of the proposal, which starts beside the ego.
  EXPECT_NEAR(points.front().pose.x, 0.0, 0.05);
  const double offset =
      shippedConfig().planners.pdm.lateral_offsets[best(planner).proposal.lateral];
  EXPECT_NEAR(points.front().pose.y, offset, 1e-3);
  EXPECT_NEAR(points.front().pose.yaw, 0.0, 1e-3);
  EXPECT_EQ(points.front().speed, 8.0);
  for (std::size_t i = 1; i < points.size(); ++i) EXPECT_GT(points[i].time, points[i - 1].time);
}

TEST(PdmPlanner, StaysBehindAStandingCar) {
  const std::vector<Track> agents = {agentAt("lead", {45.0, 0.0, 0.0}, 0.0)};
  PdmPlanner planner = plannerOn(taskOn(threeLaneRoad()));
  const std::vector<TrajectoryPoint> points = planner.plan({egoAt({0.0, 0.0, 0.0}, 8.0), agents});
  EXPECT_FALSE(touchesAnybody(points, agents));
  EXPECT_LT(points.back().speed, 2.0);
  EXPECT_EQ(best(planner).score.collision, 1.0);
}

TEST(PdmPlanner, PassesAnObstacleThatReachesSlightlyIntoItsPath) {
  // A parked car that touches the corridor of the centreline but not the one at -1 m.
  auto map = std::make_shared<LaneMap>(threeLaneRoad()->map());
  map->drivable_area = {rectangle(-200.0, -5.0, 400.0, 8.75)};
  const auto lanes = std::make_shared<const LaneIndex>(map);
  const std::vector<Track> agents = {agentAt("parked", {40.0, 1.7, 0.0}, 0.0)};
  PdmPlanner planner = plannerOn(taskOn(lanes));
  const std::vector<TrajectoryPoint> points = planner.plan({egoAt({0.0, 0.0, 0.0}, 8.0), agents});
  EXPECT_EQ(best(planner).proposal.lateral, 1U);
  EXPECT_FALSE(touchesAnybody(points, agents));
  EXPECT_GT(points.back().pose.x, 50.0);
}

TEST(PdmPlanner, BrakesInAnEmergency) {
  // A car stands 2 m ahead of the ego's front; at 5 m/s no proposal stops in time.
  const EgoVehicle& ego = shippedConfig().ego_vehicle;
  const double gap = 2.0;
  const std::vector<Track> agents = {
      agentAt("lead", {gap + 0.5 * (ego.size.length + 4.6), 0.0, 0.0}, 0.0, {4.6, 9.0})};
  PdmPlanner planner = plannerOn(taskOn(threeLaneRoad()));
  const std::vector<TrajectoryPoint> points = planner.plan({egoAt({0.0, 0.0, 0.0}, 4.9), agents});
  EXPECT_TRUE(planner.closed()->isEmergencyBraking());
  ASSERT_EQ(points.size(), 81U);
  // The braking poses have a speed of 1.1 (4.9 - 4.05) m/s.
  EXPECT_NEAR(points.back().pose.x, 8.0 * 1.1 * 0.85, 1e-9);
  // Above 5 m/s the ego follows the best proposal.
  planner.plan({egoAt({0.0, 0.0, 0.0}, 5.1), agents});
  EXPECT_FALSE(planner.closed()->isEmergencyBraking());
}

TEST(PdmPlanner, IgnoresAnAgentThatTouchedTheEgo) {
  const std::vector<Track> touching = {agentAt("a", {4.0, 0.0, 0.0}, 0.0)};
  PdmPlanner planner = plannerOn(taskOn(threeLaneRoad()));
  const std::vector<TrajectoryPoint> points = planner.plan({egoAt({0.0, 0.0, 0.0}, 5.0), touching});
  EXPECT_GT(points.back().speed, 8.0);
  EXPECT_TRUE(touchesAnybody(points, touching));
}

TEST(PdmPlanner, TheSameTaskAndObservationsGiveTheSameTrajectories) {
  const std::vector<Track> agents = {agentAt("lead", {25.0, 0.0, 0.0}, 3.0),
                                     agentAt("beside", {5.0, 3.5, 0.0}, 9.0)};
  PdmPlanner one = plannerOn(taskOn(threeLaneRoad()));
  PdmPlanner other = plannerOn(taskOn(threeLaneRoad()));
  other.plan({egoAt({-5.0, 0.0, 0.0}, 3.0), {}});
  other.initialize(taskOn(threeLaneRoad()));
  const auto first = one.plan({egoAt({0.0, 0.0, 0.0}, 8.0), agents});
  const auto second = other.plan({egoAt({0.0, 0.0, 0.0}, 8.0), agents});
  ASSERT_EQ(first.size(), second.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(first[i].pose.x, second[i].pose.x);
    EXPECT_EQ(first[i].speed, second[i].speed);
  }
}

TEST(PdmPlanner, RejectsATaskWithoutLanesOrRoute) {
  const PlannerOptions& options = shippedConfig().planners;
  PdmPlanner planner(options.pdm, options.route_centerline, options.car, options.lqr);
  EXPECT_THROW(planner.initialize({}), std::invalid_argument);
  DrivingTask task = taskOn(threeLaneRoad());
  task.route = {{1.0, 1.0}};
  EXPECT_THROW(planner.initialize(task), std::invalid_argument);
}

}  // namespace
}  // namespace forge
