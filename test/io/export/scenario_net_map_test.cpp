#include "collision_forge/io/export/scenario_net_map.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/export/inlined.h"

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

TEST(ScenarioNetMap, LanesLinkOnlyToExistingLanes) {
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
  const std::string json = inlined(features.content());
  EXPECT_THAT(json, HasSubstr(R"("l2":{"type":"LANE_SURFACE_UNSTRUCTURE","is_intersection":true,)"
                              R"("polyline":[[20,0],[40,0]],"entry_lanes":["l1"],"exit_lanes":[],)"
                              R"("left_neighbor":[],"right_neighbor":[],"speed_limit_kmh":36})"));
  EXPECT_THAT(json, HasSubstr(R"("type":"LANE_SURFACE_STREET","is_intersection":false,)"));
  EXPECT_THAT(json, HasSubstr(R"("exit_lanes":["l2"])"));
  EXPECT_THAT(json, Not(HasSubstr("point")));
}

TEST(ScenarioNetMap, WritesWalkwaysAndRoadEdges) {
  LaneMap map;
  map.walkways = {{{{0, 4}, {20, 4}, {20, 6}}, {}},
                  {{{0, 8}, {9, 8}, {9, 17}}, {{{7, 9}, {8, 9}, {8, 10}}}}};
  PickleWriter features;
  EXPECT_EQ(writeMapFeatures(features, map, {{{0, -4}, {20, -4}, {20, 4}}}), 3u);
  EXPECT_EQ(inlined(features.content()),
            R"({"map_features":{)"
            R"("walkway_0":{"type":"ROAD_EDGE_SIDEWALK","polygon":[[0,4],[20,4],[20,6]]},)"
            R"("walkway_1":{"type":"ROAD_EDGE_SIDEWALK","polygon":[[0,8],[9,8],[9,17]],)"
            R"("interiors":[[[7,9],[8,9],[8,10]]]},)"
            R"("edge_2":{"type":"ROAD_EDGE_BOUNDARY","polyline":[[0,-4],[20,-4],[20,4]]}}})");
}

TEST(ScenarioNetMap, WritesPaintedLinesAndLanesOfBicycles) {
  LaneMap map;
  map.features = {{FeatureKind::kSolidYellowLine, {{0, 2}, {9, 2}}},
                  {FeatureKind::kBikeLane, {{0, -3}, {9, -3}}}};
  PickleWriter features;
  EXPECT_EQ(writeMapFeatures(features, map, {}), 2u);
  EXPECT_EQ(inlined(features.content()),
            R"({"map_features":{)"
            R"("feature_0":{"type":"ROAD_LINE_SOLID_SINGLE_YELLOW","polyline":[[0,2],[9,2]]},)"
            R"("feature_1":{"type":"LANE_BIKE_LANE","polyline":[[0,-3],[9,-3]]}}})");
}

TEST(ScenarioNetMap, TheGroundHasItsSideAndPolygonsWithTheirHoles) {
  LaneMap map;
  map.driving_side = DrivingSide::kLeft;
  map.drivable_area = {{{{0, 0}, {9, 0}, {9, 9}}, {{{7, 1}, {8, 1}, {8, 2}}}},
                       {{{0, 20}, {1, 20}, {1, 21}}, {}}};
  EXPECT_EQ(inlined([&](PickleWriter& writer) { writeGround(writer, map); }),
            R"({"driving_side":"left","drivable_area":[)"
            R"({"exterior":[[0,0],[9,0],[9,9]],"interiors":[[[7,1],[8,1],[8,2]]]},)"
            R"({"exterior":[[0,20],[1,20],[1,21]],"interiors":[]}]})");
}

}  // namespace
}  // namespace forge
