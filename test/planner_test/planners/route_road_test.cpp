#include "collision_forge/planner_test/planners/route_road.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "planner_test/planners/planner_scenes.h"

namespace forge {
namespace {

RouteRoad roadOf(const LaneIndex& lanes, const std::vector<Vector2>& route) {
  const PlannerOptions& options = shippedConfig().planners;
  return roadAlong(lanes, route, options.route_centerline, options.pdm.map);
}

PdmPlace placeAt(const RouteRoad& road, double y) {
  return road.map.placeOf({{0.0, y, 0.0}, {4.0, 1.8}});
}

TEST(RouteRoad, LanesOfTheSameDirectionAreOnTheRoute) {
  const auto lanes = threeLaneRoad();
  const RouteRoad road = roadOf(*lanes, routeAlong(*lanes, 0));
  EXPECT_FALSE(placeAt(road, 0.0).is_wrong_way);
  EXPECT_FALSE(placeAt(road, 3.5).is_wrong_way);
  EXPECT_TRUE(placeAt(road, 7.0).is_wrong_way);
  EXPECT_TRUE(placeAt(road, 1.75).is_in_several_lanes);
}

TEST(RouteRoad, NodesAreAMetreApart) {
  const auto lanes = threeLaneRoad();
  const RouteRoad road = roadOf(*lanes, {{0.0, 0.2}, {100.0, 0.2}});
  ASSERT_GE(road.nodes.size(), 95U);
  EXPECT_NEAR(road.nodes[20].y, 0.0, 1e-6);
  EXPECT_NEAR(road.nodes[21].x - road.nodes[20].x, 1.0, 0.1);
}

TEST(RouteRoad, ARouteOnTheOncomingLaneIsOnTheRoute) {
  const auto lanes = threeLaneRoad();
  EXPECT_FALSE(placeAt(roadOf(*lanes, {{-100.0, 12.0}, {200.0, 12.0}}), 12.0).is_wrong_way);
}

TEST(RouteRoad, NeedsARoute) {
  EXPECT_THROW(roadOf(*threeLaneRoad(), {{1.0, 1.0}}), std::invalid_argument);
}

}  // namespace
}  // namespace forge
