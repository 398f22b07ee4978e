#include "collision_forge/io/maps/common_road_map.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "collision_forge/io/maps/map_error.h"
#include "collision_forge/io/maps/map_file.h"
#include "io/logs/nuscenes_fixture.h"
#include "io/maps/map_options.h"
#include "io/maps/small_common_road.h"

namespace forge {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string ref(const std::string& element, const std::string& id, const std::string& more = "") {
  return SmallCommonRoad::ref(element, id, more);
}

LaneMap readSmall(const std::string& text, std::vector<std::string>* warnings = nullptr) {
  const TemporaryFolder folder;
  return readMapFile(folder.write("town.xml", text), mapOptions(), warnings);
}

std::vector<std::string> idsOf(const LaneMap& map) {
  std::vector<std::string> ids;
  for (const Lane& lane : map.lanes) ids.push_back(lane.id);
  return ids;
}

TEST(CommonRoadMap, TheCentrelineIsTheMeanOfTheBounds) {
  SmallCommonRoad file;
  file.lanelet("1", 5.0, 2.0, "<laneletType>urban</laneletType>");
  const LaneMap map = readSmall(file.text());
  EXPECT_EQ(map.location, "town");
  ASSERT_EQ(map.lanes.size(), 1U);
  const Lane& lane = map.lanes[0];
  EXPECT_EQ(lane.centerline.size(), 21U) << "one pose a metre";
  EXPECT_NEAR((lane.centerline.front().position() - Vector2(5.0, 2.0)).norm(), 0.0, 1e-9);
  EXPECT_NEAR((lane.centerline.back().position() - Vector2(25.0, 2.0)).norm(), 0.0, 1e-9);
  EXPECT_EQ(lane.polygon.size(), 4U);
  EXPECT_EQ(map.drivable_area.size(), 1U);
}

TEST(CommonRoadMap, LinksAreMutualAndToLaneletsOfTheFile) {
  SmallCommonRoad file;
  file.lanelet("1", 0.0, 0.0, ref("successor", "2") + ref("successor", "77"));
  file.lanelet("2", 20.0, 0.0);
  const LaneMap map = readSmall(file.text());
  EXPECT_THAT(map.lanes[0].outgoing, ElementsAre("2"));
  EXPECT_THAT(map.lanes[1].incoming, ElementsAre("1"));
}

TEST(CommonRoadMap, UsersComeBeforeTypes) {
  SmallCommonRoad file;
  file.lanelet("1", 0.0, 0.0, "<laneletType>busLane</laneletType>");
  file.lanelet("2", 0.0, 3.0, "<laneletType>busLane</laneletType><userOneWay>car</userOneWay>");
  file.lanelet("3", 0.0, 6.0, "<laneletType>urban</laneletType><userOneWay>bus</userOneWay>");
  file.lanelet("4", 0.0, 9.0, "<laneletType>sidewalk</laneletType>");
  file.lanelet("5", 0.0, 12.0, "<laneletType>crosswalk</laneletType>");
  const LaneMap map = readSmall(file.text());
  EXPECT_THAT(idsOf(map), ElementsAre("2"));
  EXPECT_EQ(map.drivable_area.size(), 3U);
  EXPECT_EQ(map.walkways.size(), 1U);
}

TEST(CommonRoadMap, ALaneletOfBothDirectionsBecomesTwoLanes) {
  SmallCommonRoad file;
  const std::string both = "<userBidirectional>vehicle</userBidirectional>";
  file.lanelet("1", 0.0, 0.0, ref("successor", "2") + both);
  file.lanelet("2", 20.0, 0.0, ref("predecessor", "1") + both);
  const LaneMap map = readSmall(file.text());
  EXPECT_THAT(idsOf(map), ElementsAre("1", "1:reverse", "2", "2:reverse"));
  EXPECT_NEAR(map.lanes[1].centerline.front().x, 20.0, 1e-9);
  EXPECT_THAT(map.lanes[3].outgoing, ElementsAre("1:reverse"));
}

TEST(CommonRoadMap, LaneletsOfIntersectionsAreConnectors) {
  SmallCommonRoad file;
  file.lanelet("1", 0.0, 0.0).lanelet("2", 20.0, 0.0);
  file.lanelet("3", 40.0, 0.0, "<laneletType>intersection</laneletType>");
  file.add("<intersection id='9'><incoming id='8'>" + ref("incomingLanelet", "1") +
           ref("successorsStraight", "2") + "</incoming></intersection>");
  const LaneMap map = readSmall(file.text());
  EXPECT_FALSE(map.lanes[0].is_connector);
  EXPECT_TRUE(map.lanes[1].is_connector && map.lanes[1].is_intersection);
  EXPECT_TRUE(map.lanes[2].is_connector && map.lanes[2].is_intersection);
}

TEST(CommonRoadMap, SpeedLimitsOfBothVersionsAreRead) {
  SmallCommonRoad file;
  file.lanelet("1", 0.0, 0.0, "<speedLimit>13.5</speedLimit>");
  file.lanelet("2", 20.0, 0.0, ref("trafficSignRef", "7"));
  file.lanelet("3", 40.0, 0.0, "<speedLimit>1e9</speedLimit>");
  file.add(
      "<trafficSign id='7'><trafficSignElement><trafficSignID>274</trafficSignID>"
      "<additionalValue>8.5</additionalValue></trafficSignElement></trafficSign>");
  const LaneMap map = readSmall(file.text());
  EXPECT_EQ(map.lanes[0].speed_limit, 13.5);
  EXPECT_EQ(map.lanes[1].speed_limit, 8.5);
  EXPECT_EQ(map.lanes[2].speed_limit, std::nullopt);
}

TEST(CommonRoadMap, TheDrivingSideIsOfTheCountryElseOfAdjacentLanelets) {
  const auto sideOf = [](const std::string& benchmark, const std::string& side) {
    SmallCommonRoad file(benchmark);
    file.lanelet("1", 0.0, 0.0, ref(side, "2", "drivingDir='opposite'"));
    return readSmall(file.text()).driving_side;
  };
  EXPECT_EQ(sideOf("C-SGP_Town-1", "adjacentLeft"), DrivingSide::kLeft);
  EXPECT_EQ(sideOf("DEU_Town-1", "adjacentRight"), DrivingSide::kRight);
  EXPECT_EQ(sideOf("ZAM_Town-1", "adjacentRight"), DrivingSide::kLeft);
  EXPECT_EQ(sideOf("", "adjacentLeft"), DrivingSide::kRight);
}

TEST(CommonRoadMap, ALaneletWithoutABoundIsLeftOutWithAWarning) {
  SmallCommonRoad file("DEU_Town-1");
  file.lanelet("1", 0.0, 0.0).lanelet("2", 0.0, 0.0, "", "leftBound other");
  std::vector<std::string> warnings;
  EXPECT_THAT(idsOf(readSmall(file.text(), &warnings)), ElementsAre("1"));
  EXPECT_THAT(warnings,
              ElementsAre(HasSubstr("1 lanelets without a usable left or right bound (first: 2)")));
}

TEST(CommonRoadMap, TheStepSizeMustBePositive) {
  for (const char* const wrong : {"0", "-1", "soon"}) {
    std::string text = SmallCommonRoad().lanelet("1", 0.0, 0.0).text();
    replaceIn(text, "timeStepSize='0.1'", "timeStepSize='" + std::string(wrong) + "'");
    EXPECT_THAT(errorOf<MapError>([&] { readSmall(text); }), HasSubstr("timeStepSize"));
  }
}

}  // namespace
}  // namespace forge
