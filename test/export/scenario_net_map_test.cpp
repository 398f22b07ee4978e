#include "collision_forge/export/scenario_net_map.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "export/pickle_items.h"

namespace forge {
namespace {

using testing::HasSubstr;
using testing::Not;

Lane lane(const std::string& id, double x) {
  Lane lane;
  lane.id = id;
  lane.centerline = {{x, 0.0, 0.0}, {x + 20.0, 0.0, 0.0}};
  return lane;
}

std::string featuresOf(const LaneMap& map) {
  PickleWriter writer;
  writeMapFeatures(writer, map, {});
  return itemsOf(writer);
}

TEST(ScenarioNetMap, LanesLeadToLanesThatAreThere) {
  LaneMap map;
  map.lanes = {lane("l1", 0.0), lane("l2", 20.0), lane("point", 40.0)};
  map.lanes[0].outgoing = {"l2", "point"};
  map.lanes[1].is_connector = true;
  map.lanes[1].is_intersection = true;
  map.lanes[1].incoming = {"l1"};
  map.lanes[1].speed_limit = 10.0;
  map.lanes[2].centerline.pop_back();
  PickleWriter features;
  EXPECT_EQ(writeMapFeatures(features, map, {}), 2u);
  PickleWriter connector;
  connector.text("type", "LANE_SURFACE_UNSTRUCTURE");
  connector.flag("is_intersection", true);
  connector.numbers("polyline", {20, 0, 40, 0}, 2);
  connector.texts("entry_lanes", {"l1"});
  connector.texts("exit_lanes", {});
  connector.texts("left_neighbor", {});
  connector.texts("right_neighbor", {});
  connector.number("speed_limit_kmh", 36.0);
  const std::string bytes = itemsOf(features);
  EXPECT_THAT(bytes, HasSubstr(item(&PickleWriter::value, "l2", connector.dict())));
  EXPECT_THAT(bytes, HasSubstr(textItem("type", "LANE_SURFACE_STREET") +
                               item(&PickleWriter::flag, "is_intersection", false)));
  EXPECT_THAT(bytes, HasSubstr(item(&PickleWriter::texts, "exit_lanes", {"l2"})));
  EXPECT_THAT(bytes, Not(HasSubstr(pickledText("point"))));
}

TEST(ScenarioNetMap, AnOutlineFarFromItsLaneIsLeftOut) {
  LaneMap map;
  map.lanes = {lane("l1", 0.0)};
  map.lanes[0].polygon = {{0.0, -1.5}, {20.0, -1.5}, {20.0, 1.5}};
  EXPECT_THAT(featuresOf(map),
              HasSubstr(item(&PickleWriter::numbers, "polygon", {0, -1.5, 20, -1.5, 20, 1.5}, 2)));
  map.lanes[0].polygon = {{400.0, -1.5}, {20.0, -1.5}, {20.0, 1.5}};
  EXPECT_THAT(featuresOf(map), Not(HasSubstr(pickledText("polygon"))));
}

TEST(ScenarioNetMap, WalkwaysAndTheEdgeOfTheRoadAreTold) {
  LaneMap map;
  map.walkways = {{{{0, 4}, {20, 4}, {20, 6}}, {}},
                  {{{0, 8}, {9, 8}, {9, 17}}, {{{7, 9}, {8, 9}, {8, 10}}}}};
  PickleWriter features;
  EXPECT_EQ(writeMapFeatures(features, map, {{{0, -4}, {20, -4}, {20, 4}}}), 3u);
  PickleWriter walkway;
  walkway.text("type", "ROAD_EDGE_SIDEWALK");
  walkway.numbers("polygon", {0, 4, 20, 4, 20, 6}, 2);
  PickleWriter around;
  around.text("type", "ROAD_EDGE_SIDEWALK");
  around.numbers("polygon", {0, 8, 9, 8, 9, 17}, 2);
  around.matrices("interiors", {{7, 9, 8, 9, 8, 10}}, 2);
  PickleWriter edge;
  edge.text("type", "ROAD_EDGE_BOUNDARY");
  edge.numbers("polyline", {0, -4, 20, -4, 20, 4}, 2);
  PickleWriter expected;
  expected.beginDict("map_features");
  expected.value("walkway_0", walkway.dict());
  expected.value("walkway_1", around.dict());
  expected.value("edge_2", edge.dict());
  expected.endDict();
  EXPECT_EQ(itemsOf(features), itemsOf(expected));
}

TEST(ScenarioNetMap, TheGroundHasItsSideAndPolygonsWithTheirHoles) {
  LaneMap map;
  map.driving_side = DrivingSide::kLeft;
  map.drivable_area = {{{{0, 0}, {9, 0}, {9, 9}}, {{{7, 1}, {8, 1}, {8, 2}}}},
                       {{{0, 20}, {1, 20}, {1, 21}}, {}}};
  PickleWriter first;
  first.numbers("exterior", {0, 0, 9, 0, 9, 9}, 2);
  first.matrices("interiors", {{7, 1, 8, 1, 8, 2}}, 2);
  PickleWriter second;
  second.numbers("exterior", {0, 20, 1, 20, 1, 21}, 2);
  second.matrices("interiors", {}, 2);
  PickleWriter expected;
  expected.text("driving_side", "left");
  expected.values("drivable_area", {first.dict(), second.dict()});
  PickleWriter ground;
  writeGround(ground, map);
  EXPECT_EQ(itemsOf(ground), itemsOf(expected));
}

}  // namespace
}  // namespace forge
