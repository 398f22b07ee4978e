#include "collision_forge/planners/lane_areas.h"

#include <gtest/gtest.h>

#include "planners/planner_scenes.h"

namespace forge {
namespace {

TEST(LaneAreas, ABoxAcrossAnEdgeIsInSeveralLanes) {
  const auto lanes = threeLaneRoad();
  const LaneAreas areas(*lanes, {0.0, 0.0}, 50.0);
  EXPECT_FALSE(areas.inSeveralLanes({{0.0, 0.0, 0.0}, kCarSize}));
  EXPECT_FALSE(areas.inSeveralLanes({{0.0, 3.5, 0.1}, kCarSize}));
  EXPECT_TRUE(areas.inSeveralLanes({{0.0, 1.75, 0.0}, kCarSize}));
}

TEST(LaneAreas, ABoxHalfOnTheVergeIsInOneLane) {
  const auto lanes = threeLaneRoad();
  EXPECT_FALSE(LaneAreas(*lanes, {0.0, 0.0}, 50.0).inSeveralLanes({{0.0, -1.5, 0.0}, kCarSize}));
}

TEST(LaneAreas, ABoxInOneOfLanesThatOverlapIsInThatLane) {
  auto map = std::make_shared<LaneMap>();
  map->lanes = {outlinedLane("a", {0.0, 0.0}, {50.0, 0.0}),
                outlinedLane("b", {0.0, 1.0}, {50.0, 1.0})};
  const LaneIndex lanes(map);
  EXPECT_FALSE(LaneAreas(lanes, {20.0, 0.0}, 50.0).inSeveralLanes({{20.0, 0.0, 0.0}, kCarSize}));
}

TEST(LaneAreas, OncomingIsALaneThatHeadsTheOtherWay) {
  const auto lanes = threeLaneRoad();
  const LaneAreas areas(*lanes, {0.0, 0.0}, 50.0);
  EXPECT_TRUE(areas.isOncoming({10.0, 7.0, 0.0}));
  EXPECT_FALSE(areas.isOncoming({10.0, 7.0, M_PI}));
  EXPECT_FALSE(areas.isOncoming({10.0, 0.0, 0.3}));
  EXPECT_FALSE(areas.isOncoming({10.0, 20.0, 0.0}));  // in no lane
}

TEST(LaneAreas, WhereLanesCrossOneThatHeadsAlongIsEnough) {
  auto map = std::make_shared<LaneMap>();
  map->lanes = {outlinedLane("east", {-30.0, 0.0}, {30.0, 0.0}),
                outlinedLane("west", {30.0, 0.5}, {-30.0, 0.5})};
  const LaneIndex lanes(map);
  EXPECT_FALSE(LaneAreas(lanes, {0.0, 0.0}, 50.0).isOncoming({0.0, 0.2, 0.0}));
  EXPECT_TRUE(LaneAreas(lanes, {0.0, 0.0}, 50.0).isOncoming({0.0, 2.1, 0.0}));
}

TEST(LaneAreas, LanesOutOfReachAndWithoutOutlineAreNotKnown) {
  const auto lanes = threeLaneRoad();
  EXPECT_FALSE(LaneAreas(*lanes, {0.0, 60.0}, 10.0).isOncoming({0.0, 7.0, 0.0}));
  auto map = std::make_shared<LaneMap>();
  map->lanes = {outlinedLane("west", {30.0, 0.0}, {-30.0, 0.0})};
  map->lanes[0].polygon.clear();
  const LaneIndex bare(map);
  EXPECT_FALSE(LaneAreas(bare, {0.0, 0.0}, 50.0).isOncoming({0.0, 0.0, 0.0}));
}

}  // namespace
}  // namespace forge
