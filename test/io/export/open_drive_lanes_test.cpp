#include "collision_forge/io/export/open_drive_lanes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <pugixml.hpp>

#include "collision_forge/io/export/linked_lanes.h"
#include "collision_forge/io/export/open_drive.h"
#include "io/export/crash_fixture.h"

namespace forge {
namespace {

using pugi::xml_node;
using testing::ElementsAre;

/// One straight lane along x, 40 m long and 3.5 m wide, with the features and walkways that a test
/// adds, as OpenDRIVE.
class OpenDriveLanesTest : public testing::Test {
 protected:
  OpenDriveLanesTest() {
    record_.ego.states = {AgentState{}};
    map().lanes = {{"a", false, false, {{0, 0, 0}, {40, 0, 0}}, {}, {}, {}, {}}};
  }

  LaneMap& map() { return record_.lanes; }

  void write() {
    const OpenDriveFile file = openDriveFile(record_, shippedConfig().exports);
    ASSERT_TRUE(document_.load_string(file.text.c_str()));
  }

  xml_node road(int number = 1) const {
    return document_.document_element().find_child_by_attribute("road", "id",
                                                                std::to_string(number).c_str());
  }

  xml_node lane(int id, int road_number = 1) const {
    const std::string path = "lanes/laneSection//lane[@id='" + std::to_string(id) + "']";
    return road(road_number).select_node(path.c_str()).node();
  }

  static std::vector<std::string> marksOf(xml_node lane) {
    std::vector<std::string> marks;
    for (const xml_node mark : lane.children("roadMark")) {
      marks.push_back(std::string(mark.attribute("sOffset").value()) + " " +
                      mark.attribute("type").value() + " " + mark.attribute("color").value());
    }
    return marks;
  }

  static std::vector<std::string> objectsOf(xml_node road) {
    std::vector<std::string> objects;
    for (const xml_node object : road.child("objects").children("object")) {
      objects.push_back(std::string(object.attribute("type").value()) + " " +
                        object.attribute("name").value());
    }
    return objects;
  }

  CrashRecord record_ = slowCarRecord();
  pugi::xml_document document_;
};

TEST_F(OpenDriveLanesTest, MarksAreAssumedWhereTheMapHasNoLines) {
  write();
  EXPECT_STREQ(lane(-1).attribute("type").value(), "driving");
  EXPECT_THAT(marksOf(lane(0)), ElementsAre("0 solid standard"));
  EXPECT_THAT(marksOf(lane(-1)), ElementsAre("0 solid standard"));
}

TEST_F(OpenDriveLanesTest, MarksFollowThePaintedLinesOfTheMap) {
  map().features = {{FeatureKind::kBrokenWhiteLine, {{-5, -1.6}, {20, -1.6}}},
                    {FeatureKind::kSolidYellowLine, {{45, 1.75}, {30, 1.75}}},
                    {FeatureKind::kBrokenYellowLine, {{-5, -2.5}, {45, -2.5}}},  // too far away
                    {FeatureKind::kSolidWhiteLine, {{35, -2.0}, {35, 2.0}}}};    // crosses
  write();
  EXPECT_THAT(marksOf(lane(-1)), ElementsAre("0 broken white", "20 solid standard"));
  EXPECT_THAT(marksOf(lane(0)), ElementsAre("0 solid standard", "30 solid yellow"));
}

TEST_F(OpenDriveLanesTest, LanesOfBicyclesAreRoadsOfTheirOwn) {
  map().features = {{FeatureKind::kBikeLane, {{0, -2.5}, {20, -2.5}, {40, -2.5}}}};
  write();
  EXPECT_STREQ(road(2).attribute("name").value(), "bike_1");
  EXPECT_STREQ(lane(-1, 2).attribute("type").value(), "biking");
  EXPECT_DOUBLE_EQ(lane(-1, 2).child("width").attribute("a").as_double(), kBikeLaneWidth);
  EXPECT_DOUBLE_EQ(road(2).attribute("length").as_double(), 40.0);
}

TEST_F(OpenDriveLanesTest, AWalkwayAlongARoadIsALane) {
  map().walkways = {{{{-5, -4.75}, {45, -4.75}, {45, -2.75}, {-5, -2.75}}, {}}};
  map().drivable_area = {{{{-5, -3}, {45, -3}, {45, 3}, {-5, 3}}, {}}};
  write();
  EXPECT_STREQ(lane(-2).attribute("type").value(), "shoulder");
  EXPECT_NEAR(lane(-2).child("width").attribute("a").as_double(), 1.0, 1e-9);
  EXPECT_STREQ(lane(-3).attribute("type").value(), "sidewalk");
  EXPECT_NEAR(lane(-3).child("width").attribute("a").as_double(), 2.0, 1e-9);
  EXPECT_TRUE(lane(1).empty());
  EXPECT_THAT(objectsOf(road()), ElementsAre("none walkway"));
}

TEST_F(OpenDriveLanesTest, AWalkwayAlongLessThanMostOfARoadIsNoLane) {
  map().walkways = {{{{10, -4.75}, {35, -4.75}, {35, -1.75}, {10, -1.75}}, {}}};
  write();
  EXPECT_TRUE(lane(-2).empty());
  EXPECT_THAT(objectsOf(road()), ElementsAre("none walkway"));
}

TEST_F(OpenDriveLanesTest, AWalkwayMayEndWithinARoad) {
  map().walkways = {{{{-5, -4.75}, {31, -4.75}, {31, -1.75}, {-5, -1.75}}, {}}};
  write();
  const xml_node sidewalk = lane(-2);
  ASSERT_STREQ(sidewalk.attribute("type").value(), "sidewalk");
  EXPECT_NEAR(sidewalk.child("width").attribute("a").as_double(), 3.0, 1e-9);
  const xml_node last = sidewalk.find_child_by_attribute("width", "sOffset", "32");
  ASSERT_FALSE(last.empty());
  EXPECT_DOUBLE_EQ(last.attribute("a").as_double(), 0.0);
}

TEST_F(OpenDriveLanesTest, CrosswalksAndIslandsAreObjectsOfTheNearestRoad) {
  map().lanes.push_back({"b", false, false, {{0, 30, 0}, {40, 30, 0}}, {}, {}, {}, {}});
  map().features = {
      {FeatureKind::kCrosswalk, {{10, -2}, {13, -2}, {13, 2}, {10, 2}}},
      {FeatureKind::kMedian, {{20, 27}, {30, 27}, {30, 28}, {20, 28}, {20, 27}}},
      {FeatureKind::kMedian, {{20, 26}, {30, 26}, {30, 27}}},  // open: an edge, no island
      {FeatureKind::kCrosswalk, {{10, 90}, {13, 90}, {13, 94}, {10, 94}}}};  // far from both
  map().drivable_area = {{{{-5, -50}, {45, -50}, {45, 50}, {-5, 50}},
                          {{{5, 4}, {8, 4}, {8, 6}, {5, 6}},               // an island
                           {{5, -40}, {40, -40}, {40, -10}, {5, -10}}}}};  // a block
  write();
  EXPECT_THAT(objectsOf(road(1)), ElementsAre("crosswalk crosswalk", "trafficIsland island"));
  EXPECT_THAT(objectsOf(road(2)), ElementsAre("trafficIsland island"));
  const xml_node crosswalk = road(1).child("objects").child("object");
  EXPECT_NEAR(crosswalk.attribute("s").as_double(), 11.5, 1e-9);
  EXPECT_NEAR(crosswalk.attribute("t").as_double(), 0.0, 1e-9);
  const xml_node corner = crosswalk.select_node("outlines/outline/cornerLocal[1]").node();
  EXPECT_NEAR(corner.attribute("u").as_double(), -1.5, 1e-9);
  EXPECT_NEAR(corner.attribute("v").as_double(), -2.0, 1e-9);
}

}  // namespace
}  // namespace forge
