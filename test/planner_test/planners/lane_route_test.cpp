#include "collision_forge/planner_test/planners/lane_route.h"

#include <gtest/gtest.h>

#include "planner_test/planners/planner_scenes.h"

namespace forge {
namespace {

const RouteCenterlineOptions& options() { return shippedConfig().planners.route_centerline; }

std::vector<std::string> idsOf(const LaneIndex& lanes, const std::vector<std::size_t>& route) {
  std::vector<std::string> ids;
  for (const std::size_t lane : route) ids.push_back(lanes.map().lanes[lane].id);
  return ids;
}

using Ids = std::vector<std::string>;

/// A lane that forks into a straight lane and one to the left.
LaneIndex fork() {
  auto map = std::make_shared<LaneMap>();
  map->lanes = {outlinedLane("in", {0.0, 0.0}, {50.0, 0.0}, {"left", "on"}),
                outlinedLane("left", {50.0, 0.0}, {100.0, 20.0}, {"left_out"}),
                outlinedLane("left_out", {100.0, 20.0}, {150.0, 40.0}),
                outlinedLane("on", {50.0, 0.0}, {100.0, 0.0}, {"on_out"}),
                outlinedLane("on_out", {100.0, 0.0}, {150.0, 0.0})};
  return LaneIndex(map);
}

TEST(LaneRoute, TakesTheBranchOfTheRoute) {
  const LaneIndex lanes = fork();
  const Pose2 start{10.0, 0.0, 0.0};
  EXPECT_EQ(idsOf(lanes, laneRoute(lanes, {{0.0, 0.0}, {150.0, 0.0}}, start, options())),
            (Ids{"in", "on", "on_out"}));
  EXPECT_EQ(
      idsOf(lanes, laneRoute(lanes, {{0.0, 0.0}, {50.0, 0.0}, {150.0, 40.0}}, start, options())),
      (Ids{"in", "left", "left_out"}));
}

TEST(LaneRoute, StartsInTheLaneThatContainsTheEgo) {
  const auto lanes = threeLaneRoad();
  const std::vector<Vector2> route = {{0.0, 1.0}, {100.0, 1.0}};
  EXPECT_EQ(idsOf(*lanes, laneRoute(*lanes, route, {0.0, 1.0, 0.0}, options())), (Ids{"right"}));
  EXPECT_EQ(idsOf(*lanes, laneRoute(*lanes, route, {0.0, 2.0, 0.0}, options())), (Ids{"left"}));
}

TEST(LaneRoute, DoesNotChangeLanes) {
  const auto lanes = threeLaneRoad();
  const std::vector<Vector2> route = {{0.0, 0.0}, {50.0, 0.0}, {70.0, 3.5}, {150.0, 3.5}};
  EXPECT_EQ(idsOf(*lanes, laneRoute(*lanes, route, {0.0, 0.0, 0.0}, options())), (Ids{"right"}));
}

TEST(LaneRoute, IsEmptyOffTheLanes) {
  const auto lanes = threeLaneRoad();
  EXPECT_TRUE(
      laneRoute(*lanes, {{0.0, -60.0}, {0.0, -90.0}}, {0.0, -60.0, -M_PI_2}, options()).empty());
}

}  // namespace
}  // namespace forge
