#include "collision_forge/io/maps/open_drive_map.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "base/scene/shipped_limits.h"
#include "collision_forge/io/maps/map_error.h"
#include "collision_forge/io/maps/map_file.h"
#include "io/logs/nuscenes_fixture.h"
#include "io/maps/open_drive_fixture.h"

namespace forge {
namespace {

using namespace open_drive;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::ThrowsMessage;
using testing::UnorderedElementsAre;

struct ReadMap {
  LaneMap map;
  std::vector<std::string> warnings;
};

ReadMap readText(const std::string& text) {
  const TemporaryFolder folder;
  folder.write("town.xodr", text);
  DataOptions options;
  options.conversion.centerline_resolution = 1.0;
  options.input_limits = shippedLimits();
  ReadMap result;
  result.map = readMapFile(folder.path() + "/town.xodr", options, &result.warnings);
  return result;
}

/// Reads roads of a file; there must be no warning.
LaneMap readRoads(const std::string& roads, const std::string& header = "") {
  const ReadMap result = readText(file(roads, header));
  EXPECT_THAT(result.warnings, IsEmpty());
  return result.map;
}

const Lane& laneOf(const LaneMap& map, const std::string& id) {
  for (const Lane& lane : map.lanes) {
    if (lane.id == id) return lane;
  }
  throw std::logic_error("no lane " + id);
}

std::vector<std::string> idsOf(const LaneMap& map) {
  std::vector<std::string> ids;
  for (const Lane& lane : map.lanes) ids.push_back(lane.id);
  return ids;
}

bool isOnRoad(const LaneMap& map, const Vector2& point) {
  return std::any_of(map.drivable_area.begin(), map.drivable_area.end(),
                     [&](const Polygon& area) { return contains(area, point); });
}

bool isOnWalkway(const LaneMap& map, const Vector2& point) {
  return std::any_of(map.walkways.begin(), map.walkways.end(),
                     [&](const Polygon& area) { return contains(area, point); });
}

const std::string kBothWays =
    section(0, lane(1, "driving", width(3)), lane(-1, "driving", width(4)));

TEST(OpenDriveMap, rightHandTrafficDrivesAlongTheReferenceLineOnItsRight) {
  const LaneMap map = readRoads(road("7", geometry(0, 0, 0, 0, 50), kBothWays));
  EXPECT_EQ(map.driving_side, DrivingSide::kRight);
  EXPECT_THAT(idsOf(map), UnorderedElementsAre("7.0.1", "7.0.-1"));
  const Lane& right = laneOf(map, "7.0.-1");
  EXPECT_NEAR(right.centerline.front().x, 0.0, 1e-9);
  EXPECT_NEAR(right.centerline.back().x, 50.0, 1e-6);
  for (const Pose2& pose : right.centerline) {
    EXPECT_NEAR(pose.y, -2.0, 1e-9);
    EXPECT_NEAR(pose.yaw, 0.0, 1e-9);
  }
  const Lane& left = laneOf(map, "7.0.1");
  EXPECT_NEAR(left.centerline.front().x, 50.0, 1e-6);
  EXPECT_NEAR(left.centerline.front().y, 1.5, 1e-9);
  EXPECT_NEAR(std::abs(left.centerline.front().yaw), M_PI, 1e-9);
  EXPECT_TRUE(contains({right.polygon, {}}, {25.0, -3.9}));
  EXPECT_FALSE(contains({right.polygon, {}}, {25.0, -4.1}));
}

TEST(OpenDriveMap, leftHandTrafficDrivesAlongTheReferenceLineOnItsLeft) {
  const LaneMap map =
      readRoads(road("7", geometry(0, 0, 0, 0, 50), kBothWays, "", "junction='-1' rule='LHT'"));
  EXPECT_EQ(map.driving_side, DrivingSide::kLeft);
  EXPECT_NEAR(laneOf(map, "7.0.1").centerline.back().x, 50.0, 1e-6);
  EXPECT_NEAR(laneOf(map, "7.0.-1").centerline.back().x, 0.0, 1e-9);
}

TEST(OpenDriveMap, lanesOfAnArcAreConcentric) {
  const LaneMap map =
      readRoads(road("7", geometry(0, 0, 0, 0, 100, "<arc curvature='0.02'/>"), kBothWays));
  for (const auto& [id, radius] : {std::pair("7.0.-1", 52.0), std::pair("7.0.1", 48.5)}) {
    for (const Pose2& pose : laneOf(map, id).centerline) {
      const Vector2 spoke = pose.position() - Vector2(0.0, 50.0);
      EXPECT_NEAR(spoke.norm(), radius, 1e-6);
      EXPECT_NEAR(spoke.normalized().dot(pose.heading()), 0.0, 1e-9);
    }
  }
}

TEST(OpenDriveMap, widthsAndTheLaneOffsetFollowTheirPolynomials) {
  const std::string offset = "<laneOffset s='0' a='1' b='0' c='0.001' d='0'/>";
  const LaneMap map = readRoads(road("7", geometry(0, 0, 0, 0, 40),
                                     offset + section(0, "", lane(-1, "driving", width(3, 0.05)))));
  const Lane& lane = laneOf(map, "7.0.-1");
  for (const Pose2& pose : lane.centerline) {
    const double s = pose.x;
    EXPECT_NEAR(pose.y, 1.0 + 0.001 * s * s - 0.5 * (3.0 + 0.05 * s), 1e-9);
    EXPECT_NEAR(pose.yaw, std::atan(0.002 * s - 0.025), 1e-9);
  }
}

TEST(OpenDriveMap, bordersGiveTheSameLanesAsWidths) {
  const auto border = [](double t) {
    return "<border sOffset='0' a='" + std::to_string(t) + "' b='0' c='0' d='0'/>";
  };
  const std::string geometries = geometry(0, 0, 0, 0, 40);
  const LaneMap by_width =
      readRoads(road("7", geometries,
                     section(0, lane(1, "driving", width(3)),
                             lane(-1, "driving", width(3)) + lane(-2, "driving", width(2)))));
  const LaneMap by_border =
      readRoads(road("7", geometries,
                     section(0, lane(1, "driving", border(3)),
                             lane(-1, "driving", border(-3)) + lane(-2, "driving", border(-5)))));
  for (const Lane& lane : by_width.lanes) {
    const Lane& other = laneOf(by_border, lane.id);
    ASSERT_EQ(other.centerline.size(), lane.centerline.size());
    for (std::size_t i = 0; i < lane.centerline.size(); ++i) {
      EXPECT_NEAR(other.centerline[i].y, lane.centerline[i].y, 1e-9);
    }
  }
}

TEST(OpenDriveMap, aLaneThatContinuesInTheNextSectionIsOneLane) {
  const LaneMap map =
      readRoads(road("7", geometry(0, 0, 0, 0, 40),
                     section(0, lane(1, "driving", link("", "1") + width(3)),
                             lane(-1, "driving", link("", "-2") + width(3))) +
                         section(20, lane(1, "driving", link("1", "") + width(3)),
                                 lane(-1, "driving", width(0, 0.15)) +
                                     lane(-2, "driving", link("-1", "") + width(3)))));
  EXPECT_THAT(idsOf(map), UnorderedElementsAre("7.1.1", "7.0.-1", "7.1.-1"));
  const Lane& joined = laneOf(map, "7.0.-1");
  EXPECT_NEAR(joined.centerline.back().x, 40.0, 1e-6);
  EXPECT_NEAR(joined.centerline.back().y, -4.5, 1e-6);
  EXPECT_EQ(joined.polygon.size(), 2 * joined.centerline.size());
  EXPECT_TRUE(contains({joined.polygon, {}}, {10.0, -2.9}));
  EXPECT_TRUE(contains({joined.polygon, {}}, {39.9, -5.9}));
  EXPECT_NEAR(laneOf(map, "7.1.1").centerline.back().x, 0.0, 1e-6) << "driven backwards";
}

TEST(OpenDriveMap, lanesOfALongRoadAreCut) {
  const LaneMap map = readRoads(road("7", geometry(0, 0, 0, 0, 1200), kBothWays));
  ASSERT_EQ(map.lanes.size(), 6U);
  EXPECT_THAT(laneOf(map, "7.0.-1").outgoing, ElementsAre("7.1.-1"));
  EXPECT_THAT(laneOf(map, "7.1.-1").outgoing, ElementsAre("7.2.-1"));
  EXPECT_THAT(laneOf(map, "7.2.1").outgoing, ElementsAre("7.1.1"));
}

TEST(OpenDriveMap, lanesOfRoadsThatMeetHeadOnLeadToEachOther) {
  const auto lanes = [](const char* right, const char* left) {
    return section(0, lane(1, "driving", link("", left) + width(3)),
                   lane(-1, "driving", link("", right) + width(3)));
  };
  const LaneMap map = readRoads(road("a", geometry(0, 0, 0, 0, 40), lanes("1", "-1"),
                                     "<link>" + roadLink("successor", "b", "end") + "</link>") +
                                road("b", geometry(0, 80, 0, 3.14159265, 40), lanes("1", "-1"),
                                     "<link>" + roadLink("successor", "a", "end") + "</link>"));
  EXPECT_THAT(laneOf(map, "a.0.-1").outgoing, ElementsAre("b.0.1"));
  EXPECT_THAT(laneOf(map, "b.0.1").incoming, ElementsAre("a.0.-1"));
  EXPECT_THAT(laneOf(map, "b.0.-1").outgoing, ElementsAre("a.0.1"));
}

TEST(OpenDriveMap, lanesLeadThroughAJunction) {
  const ReadMap result = readText(openDriveCrossing());
  EXPECT_THAT(result.warnings, IsEmpty());
  const LaneMap& map = result.map;
  EXPECT_THAT(laneOf(map, "w.0.-1").outgoing, ElementsAre("we.0.-1"));
  EXPECT_THAT(laneOf(map, "we.0.-1").outgoing, ElementsAre("e.0.-1"));
  EXPECT_THAT(laneOf(map, "s.0.-1").outgoing, ElementsAre("sw.0.-1"));
  EXPECT_THAT(laneOf(map, "sw.0.-1").outgoing, ElementsAre("w.0.1"));
  EXPECT_TRUE(laneOf(map, "we.0.-1").is_connector);
  EXPECT_TRUE(laneOf(map, "we.0.-1").is_intersection) << "another road of the junction turns";
  EXPECT_FALSE(laneOf(map, "w.0.-1").is_connector);
}

TEST(OpenDriveMap, aDirectJunctionWithoutATurnIsNoIntersection) {
  const std::string one_lane = section(0, "", lane(-1, "driving", width(3)));
  const LaneMap map =
      readRoads(road("a", geometry(0, 0, 0, 0, 40), one_lane,
                     "<link>" + junctionLink("successor", "J") + "</link>") +
                road("b", geometry(0, 40, 0, 0.1, 40), one_lane,
                     "<link>" + junctionLink("predecessor", "J") + "</link>") +
                "<junction id='J' type='direct'><connection incomingRoad='a' linkedRoad='b' "
                "contactPoint='start'><laneLink from='-1' to='-1'/></connection></junction>");
  EXPECT_THAT(laneOf(map, "a.0.-1").outgoing, ElementsAre("b.0.-1"));
  EXPECT_FALSE(laneOf(map, "a.0.-1").is_intersection);
}

TEST(OpenDriveMap, laneTypesBecomeLanesRoadWalkwayAndIslands) {
  std::string right;
  int id = 0;
  for (const char* const type : {"driving", "biking", "parking", "sidewalk", "median", "bus"}) {
    right += lane(--id, type, width(2));
  }
  const LaneMap map = readRoads(road("7", geometry(0, 0, 0, 0, 40), section(0, "", right)));
  EXPECT_THAT(idsOf(map), UnorderedElementsAre("7.0.-1", "7.0.-6"));
  EXPECT_TRUE(isOnRoad(map, {20.0, -3.0})) << "bicycle lane";
  EXPECT_TRUE(isOnRoad(map, {20.0, -5.0})) << "parking";
  EXPECT_TRUE(isOnWalkway(map, {20.0, -7.0}));
  EXPECT_FALSE(isOnRoad(map, {20.0, -7.0}));
  EXPECT_FALSE(isOnRoad(map, {20.0, -9.0}) || isOnWalkway(map, {20.0, -9.0})) << "median";
  EXPECT_TRUE(isOnRoad(map, {20.0, -11.0})) << "bus lane";
}

/// Four roads of a junction, 3 m wide, around a square of this side, m.
LaneMap mapAroundSquare(double side) {
  const std::string lanes = section(0, "", lane(-1, "driving", width(3)));
  const auto edge = [&](const char* id, double x, double y, double heading) {
    return road(id, geometry(0, x, y, heading, side + 6), lanes, "", "junction='J'");
  };
  return readRoads(edge("1", -3, 0, 0) + edge("2", side, -3, M_PI / 2) +
                   edge("3", side + 3, side, M_PI) + edge("4", 0, side + 3, -M_PI / 2));
}

TEST(OpenDriveMap, aSmallGapInAJunctionIsRoadAndALargeOneAnIsland) {
  EXPECT_TRUE(isOnRoad(mapAroundSquare(4.0), {2.0, 2.0}));
  EXPECT_FALSE(isOnRoad(mapAroundSquare(6.0), {3.0, 3.0}));
}

TEST(OpenDriveMap, aBidirectionalLaneIsALaneEachWay) {
  const LaneMap map = readRoads(
      road("7", geometry(0, 0, 0, 0, 40), section(0, "", lane(-1, "bidirectional", width(3)))));
  EXPECT_NEAR(laneOf(map, "7.0.-1").centerline.back().x, 40.0, 1e-6);
  EXPECT_NEAR(laneOf(map, "7.0.-1.back").centerline.back().x, 0.0, 1e-6);
}

TEST(OpenDriveMap, theHeaderOffsetRotatesAndMovesTheMap) {
  const LaneMap map = readRoads(road("7", geometry(0, 10, 0, 0, 40), kBothWays),
                                "<offset x='1000' y='2000' z='5' hdg='1.5707963267948966'/>");
  const Pose2& start = laneOf(map, "7.0.-1").centerline.front();
  EXPECT_NEAR(start.x, 1002.0, 1e-6);
  EXPECT_NEAR(start.y, 2010.0, 1e-6);
  EXPECT_NEAR(start.yaw, M_PI / 2.0, 1e-6);
}

TEST(OpenDriveMap, speedLimitsAreReadInTheirUnits) {
  const std::string town = "<type s='0' type='town'><speed max='25' unit='mph'/></type>";
  const LaneMap map = readRoads(
      road("7", geometry(0, 0, 0, 0, 40),
           section(0, lane(1, "driving", width(3) + "<speed sOffset='0' max='no limit'/>"),
                   lane(-1, "driving", width(3) + "<speed sOffset='0' max='36' unit='km/h'/>")),
           town));
  EXPECT_NEAR(laneOf(map, "7.0.-1").speed_limit.value_or(0.0), 10.0, 1e-9);
  EXPECT_NEAR(laneOf(map, "7.0.1").speed_limit.value_or(0.0), 11.176, 1e-9) << "of the road";
}

TEST(OpenDriveMap, aRoadTooShortForALaneIsBridged) {
  const auto through = [](const std::string& before, const std::string& after) {
    std::string links;
    if (!before.empty()) links += roadLink("predecessor", before, "end");
    if (!after.empty()) links += roadLink("successor", after, "start");
    return "<link>" + links + "</link>";
  };
  const std::string lanes = section(0, "", lane(-1, "driving", link("-1", "-1") + width(3)));
  const LaneMap map = readRoads(road("a", geometry(0, 0, 0, 0, 40), lanes, through("", "b")) +
                                road("b", geometry(0, 40, 0, 0, 0.05), lanes, through("a", "c")) +
                                road("c", geometry(0, 40.05, 0, 0, 40), lanes, through("b", "")));
  EXPECT_THAT(idsOf(map), ElementsAre("a.0.-1", "c.0.-1"));
  EXPECT_THAT(laneOf(map, "a.0.-1").outgoing, ElementsAre("c.0.-1"));
}

/// A defect of one road, and words of its warning.
struct RoadDefect {
  std::string geometries;
  std::string lanes;
  std::string warning;
};

TEST(OpenDriveMap, aBadValueCostsItsRoadAlone) {
  const std::string line = geometry(0, 0, 9, 0, 40);
  const RoadDefect defects[] = {
      {"", kBothWays, "first: bad: the road has no reference line"},
      {geometry(0, 0, 9, 0, 40, "<curve/>"), kBothWays, "has none of line, arc, spiral"},
      {geometry(0, 0, 9, 0, 40, "<arc curvature='nan'/>"), kBothWays,
       "attribute curvature is \"nan\", not a finite number"},
      {geometry(0, 0, 9, 0, 40, "<arc curvature='50'/>"), kBothWays,
       "attribute curvature is 50, too much for a road"},
      {geometry(0, 9e9, 9, 0, 40), kBothWays, "beyond max_coordinate in input_limits.yaml"},
      {geometry(0, 0, 9, 0, 9e9), kBothWays, "longer than max_coordinate"},
      {line, "", "the road has no lane section"},
      {line, section(0, "", lane(-1, "driving", "<width sOffset='0' a='3'/>")),
       "attribute b is missing"},
      {line, section(0, "", "<lane id='x' type='driving'/>"), "the id is not an integer"},
      {line, section(0, "", lane(-1, "driving", width(9e9))),
       "1 roads with a lane section beyond the input limits (first: bad)"},
  };
  for (const RoadDefect& defect : defects) {
    const ReadMap result = readText(file(road("bad", defect.geometries, defect.lanes) +
                                         road("7", geometry(0, 0, 0, 0, 40), kBothWays)));
    EXPECT_THAT(idsOf(result.map), UnorderedElementsAre("7.0.1", "7.0.-1"));
    EXPECT_THAT(result.warnings, ElementsAre(HasSubstr(defect.warning)));
  }
}

TEST(OpenDriveMap, linksToMissingRoadsAndUnknownTypesAreCounted) {
  const std::string connection =
      "<connection incomingRoad='7' connectingRoad='8' contactPoint='start'/>";
  const ReadMap result =
      readText(file(road("7", geometry(0, 0, 0, 0, 40),
                         section(0, lane(1, "hover", width(3)), lane(-1, "driving", width(3)))) +
                    "<junction id='J'>" + connection + connection + "</junction>"));
  EXPECT_THAT(result.warnings,
              UnorderedElementsAre(
                  HasSubstr("1 lanes of a type that is not in OpenDRIVE 1.4 to 1.8 (first: hover)"),
                  HasSubstr("2 junctions with a connection of missing roads (first: J)")));
}

TEST(OpenDriveMap, otherVersionsAreRefused) {
  EXPECT_THAT([] { readText("<OpenDRIVE><header revMajor='2'/></OpenDRIVE>"); },
              ThrowsMessage<MapError>(HasSubstr("town.xodr: <header>: attribute revMajor is \"2\"; "
                                                "OpenDRIVE 1.4 to 1.8 can be read")));
}

}  // namespace
}  // namespace forge
