#include "collision_forge/planner_test/planners/route_centerline.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "planner_test/planners/planner_scenes.h"

namespace forge {
namespace {

Polyline centerlineOf(const LaneIndex& lanes, const std::vector<Vector2>& route) {
  return routeCenterline(lanes, route, shippedConfig().planners.route_centerline);
}

TEST(RouteCenterline, IsTheCentrelineOfTheLaneThatTheRouteIsOn) {
  const auto lanes = threeLaneRoad();
  const Polyline line = centerlineOf(*lanes, {{0.0, 0.8}, {100.0, 0.4}});
  for (const Vector2& point : line.points()) EXPECT_NEAR(point.y(), 0.0, 1e-3);
  EXPECT_NEAR(line.length(), 100.0, 0.1);
}

TEST(RouteCenterline, ChangesLanesWithTheRoute) {
  const auto lanes = threeLaneRoad();
  const Polyline line = centerlineOf(*lanes, {{0.0, 0.3}, {80.0, 0.3}, {110.0, 3.2}, {200.0, 3.2}});
  EXPECT_NEAR(line.project({60.0, 0.0}).lateral, 0.0, 0.01);
  EXPECT_NEAR(line.project({140.0, 3.5}).lateral, 0.0, 0.01);
  double before = 0.0;
  for (double x = 0.0; x <= 200.0; x += 2.0) {
    const double y = 3.5 - line.project({x, 3.5}).lateral;
    EXPECT_LT(std::abs(y - before), 0.9) << x;
    before = y;
  }
}

TEST(RouteCenterline, ARouteBesideItsLaneForAWhileDoesNotChangeLanes) {
  // The route swings out towards the left lane and back, as around an obstacle.
  const auto lanes = threeLaneRoad();
  const Polyline line = centerlineOf(
      *lanes, {{0.0, 0.0}, {40.0, 0.0}, {50.0, 1.9}, {54.0, 1.9}, {64.0, 0.0}, {120.0, 0.0}});
  for (const Vector2& point : line.points()) EXPECT_NEAR(point.y(), 0.0, 0.1) << point.x();
}

TEST(RouteCenterline, FollowsTheConnectorThatTheRouteTakes) {
  auto map = std::make_shared<LaneMap>();
  map->lanes = {straightLane("in", {0.0, 0.0}, {50.0, 0.0}, {"straight", "slip"}),
                straightLane("straight", {50.0, 0.0}, {100.0, 0.0}),
                straightLane("slip", {50.0, 0.0}, {98.0, 14.0})};
  const LaneIndex lanes(map);
  const Polyline line = centerlineOf(lanes, {{10.0, 0.0}, {50.0, 0.0}, {98.0, 14.0}});
  EXPECT_NEAR(line.project({90.0, 11.667}).lateral, 0.0, 0.1);
}

TEST(RouteCenterline, RejectsARouteOfOnePoint) {
  EXPECT_THROW(centerlineOf(*threeLaneRoad(), {{0.0, 0.5}, {0.0, 0.5}}), std::invalid_argument);
}

}  // namespace
}  // namespace forge
