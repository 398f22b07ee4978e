#include "collision_forge/planner_test/planners/pdm_map.h"

#include <gtest/gtest.h>

#include "planner_test/planners/planner_scenes.h"

namespace forge {
namespace {

PdmArea areaOf(double left, double low, double right, double high, bool is_on_route) {
  return {{{left, low}, {right, low}, {right, high}, {left, high}}, is_on_route, {}};
}

/// Two lanes one after the other on the route, and one beside them that is not.
PdmMap twoRoads() {
  return PdmMap({areaOf(0.0, -2.0, 50.0, 2.0, true), areaOf(50.0, -2.0, 90.0, 2.0, true),
                 areaOf(0.0, 2.0, 90.0, 6.0, false)},
                {{{80.0, -2.0}, {90.0, -2.0}, {90.0, 2.0}}});
}

OrientedBox carAt(double x, double y) { return {{x, y, 0.0}, {4.0, 2.0}}; }

TEST(PdmMap, ABoxWithinALaneIsInOne) {
  const PdmPlace place = twoRoads().placeOf(carAt(20.0, 0.0));
  EXPECT_FALSE(place.is_in_several_lanes);
  EXPECT_FALSE(place.is_off_road);
  EXPECT_FALSE(place.is_wrong_way);
}

TEST(PdmMap, ABoxAcrossLanesIsInSeveralAlsoFromALaneToTheNext) {
  EXPECT_TRUE(twoRoads().placeOf(carAt(20.0, 1.5)).is_in_several_lanes);
  EXPECT_TRUE(twoRoads().placeOf(carAt(50.0, 0.0)).is_in_several_lanes);
}

TEST(PdmMap, ACornerOffEveryAreaIsOffTheRoad) {
  EXPECT_TRUE(twoRoads().placeOf(carAt(20.0, -1.5)).is_off_road);
  EXPECT_FALSE(twoRoads().placeOf(carAt(20.0, -1.5)).is_in_several_lanes);
}

TEST(PdmMap, TheMiddleTellsTheWrongWay) {
  EXPECT_FALSE(twoRoads().placeOf(carAt(20.0, 1.9)).is_wrong_way);
  EXPECT_TRUE(twoRoads().placeOf(carAt(20.0, 2.1)).is_wrong_way);
  EXPECT_TRUE(twoRoads().placeOf(carAt(20.0, -8.0)).is_wrong_way);
}

TEST(PdmMap, TheRouteItselfIsNeverTheWrongWay) {
  PdmMap map = twoRoads();
  map.addRoute({{0.0, -12.0}, {90.0, -12.0}, {90.0, -6.0}, {0.0, -6.0}});
  EXPECT_FALSE(map.placeOf(carAt(20.0, -8.0)).is_wrong_way);
  EXPECT_TRUE(map.placeOf(carAt(20.0, -8.0)).is_off_road);
}

TEST(PdmMap, ADrivableAreaOfItsOwnHasAMargin) {
  const std::vector<Polygon> ground = {rectangle(0.0, -10.0, 90.0, 6.0)};
  const AreaRaster raster(ground);
  PdmMap map = twoRoads();
  map.setDrivable(&raster, 0.25);
  EXPECT_FALSE(map.placeOf(carAt(20.0, -8.0)).is_off_road);
  EXPECT_FALSE(map.placeOf(carAt(20.0, -9.2)).is_off_road);
  EXPECT_TRUE(map.placeOf(carAt(20.0, -9.8)).is_off_road);
}

TEST(PdmMap, TheLimitIsThatOfTheLaneOnTheRoute) {
  PdmArea here = areaOf(0.0, -2.0, 50.0, 2.0, true);
  here.speed_limit = 8.0;
  PdmArea beside = areaOf(0.0, 2.0, 50.0, 6.0, false);
  beside.speed_limit = 20.0;
  const PdmMap map({beside, here}, {});
  EXPECT_EQ(map.placeOf(carAt(20.0, 0.0)).speed_limit, std::optional<double>(8.0));
  EXPECT_EQ(map.placeOf(carAt(20.0, 4.0)).speed_limit, std::nullopt);
  EXPECT_EQ(twoRoads().placeOf(carAt(20.0, 0.0)).speed_limit, std::nullopt);
}

TEST(PdmMap, KnowsItsIntersections) {
  EXPECT_TRUE(twoRoads().isInIntersection({88.0, -1.0}));
  EXPECT_FALSE(twoRoads().isInIntersection({70.0, 0.0}));
}

}  // namespace
}  // namespace forge
