#include "collision_forge/io/maps/lanelet2_map.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "collision_forge/base/config/config_error.h"
#include "collision_forge/base/geometry/polyline.h"
#include "collision_forge/io/maps/lane_shapes.h"
#include "collision_forge/io/maps/map_error.h"
#include "collision_forge/io/maps/map_file.h"
#include "io/logs/nuscenes_fixture.h"
#include "io/maps/map_options.h"
#include "io/maps/small_lanelet2.h"

namespace forge {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

const auto tag = SmallLanelet2::tag;
const auto member = SmallLanelet2::member;

struct ReadMap {
  LaneMap map;
  std::vector<std::string> warnings;

  const Lane& lane(const std::string& id) const {
    for (const Lane& lane : map.lanes) {
      if (lane.id == id) return lane;
    }
    throw std::logic_error("no lane " + id);
  }
};

DataOptions placedOptions() {
  DataOptions options = mapOptions();
  options.origins["placed"] = {49.0, 8.4};
  return options;
}

ReadMap readSmall(const std::string& text, const DataOptions& options = mapOptions(),
                  const std::string& name = "town") {
  const TemporaryFolder folder;
  ReadMap read;
  read.map = readMapFile(folder.write(name + ".osm", text), options, &read.warnings);
  return read;
}

/// Returns the largest distance (m) of the centreline from a line.
double farthest(const Lane& lane, const std::vector<Vector2>& line) {
  const Polyline reference(line);
  double distance = 0.0;
  for (const Pose2& pose : lane.centerline) {
    distance = std::max(distance, reference.project(pose.position()).distance);
  }
  return distance;
}

std::vector<Vector2> arc(double radius, std::size_t pieces) {
  std::vector<Vector2> points;
  for (std::size_t i = 0; i <= pieces; ++i) {
    const double angle = 1.5 * static_cast<double>(i) / static_cast<double>(pieces);
    points.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return points;
}

/// A road along x with a lane to the east at y = -1.75, one to the west at 1.75, and a lane that
/// continues the first one; all bounds 20 m long.
struct TwoWayRoad {
  TwoWayRoad() {
    const auto start = nodes(0.0);
    const auto middle = nodes(20.0);
    const auto end = nodes(40.0);
    const std::string between = osm.way({start[1], middle[1]});
    east = osm.lanelet(between, osm.way({start[0], middle[0]}), "road",
                       tag("speed_limit", "36") + tag("turn_direction", "straight"));
    west = osm.lanelet(between, osm.way({middle[2], start[2]}), "road", tag("one_way", "yes"));
    next = osm.lanelet(osm.way({middle[1], end[1]}), osm.way({end[0], middle[0]}));
  }

  std::vector<std::string> nodes(double x) {
    return {osm.node({x, -3.5}), osm.node({x, 0.0}), osm.node({x, 3.5})};
  }

  SmallLanelet2 osm;
  std::string east, west, next;
};

TEST(Lanelet2Map, ALaneLiesMidwayBetweenItsBoundsInDrivingDirection) {
  const TwoWayRoad road;
  const ReadMap read = readSmall(road.osm.text());
  EXPECT_THAT(read.warnings, IsEmpty());
  EXPECT_EQ(read.map.location, "town");
  const Lane& east = read.lane(road.east);
  EXPECT_EQ(east.centerline.size(), 21U) << "one pose a metre";
  EXPECT_NEAR(east.centerline.front().x, 0.0, 1e-9);
  EXPECT_LT(farthest(east, {{0.0, -1.75}, {20.0, -1.75}}), 1e-9);
  EXPECT_EQ(east.polygon.size(), 4U);
  const Lane& west = read.lane(road.west);
  EXPECT_NEAR(west.centerline.front().x, 20.0, 1e-9);
  EXPECT_NEAR(std::abs(west.centerline.front().yaw), M_PI, 1e-9);
  EXPECT_LT(farthest(west, {{0.0, 1.75}, {20.0, 1.75}}), 1e-9);
}

TEST(Lanelet2Map, ALaneFollowsALaneThatEndsAtItsFirstNodes) {
  const TwoWayRoad road;
  const ReadMap read = readSmall(road.osm.text());
  EXPECT_THAT(read.lane(road.east).outgoing, ElementsAre(road.next));
  EXPECT_THAT(read.lane(road.next).incoming, ElementsAre(road.east));
  EXPECT_THAT(read.lane(road.west).outgoing, IsEmpty());
}

TEST(Lanelet2Map, TurnDirectionAndSpeedLimitAreRead) {
  const TwoWayRoad road;
  const ReadMap read = readSmall(road.osm.text());
  EXPECT_TRUE(read.lane(road.east).is_connector);
  EXPECT_TRUE(read.lane(road.east).is_intersection);
  EXPECT_FALSE(read.lane(road.west).is_connector);
  EXPECT_NEAR(read.lane(road.east).speed_limit.value(), 10.0, 1e-9);
  EXPECT_EQ(read.lane(road.west).speed_limit, std::nullopt);
}

TEST(Lanelet2Map, SpeedLimitsHaveUnits) {
  for (const auto& [text, speed] :
       {std::pair("30 mph", 13.4112), {"50km/h", 50.0 / 3.6}, {"5 m/s", 5.0}}) {
    SmallLanelet2 osm;
    osm.lanelet(osm.line({{0.0, 3.0}, {9.0, 3.0}}), osm.line({{0.0, 0.0}, {9.0, 0.0}}), "road",
                tag("speed_limit", text));
    EXPECT_NEAR(readSmall(osm.text()).map.lanes.at(0).speed_limit.value(), speed, 1e-6) << text;
  }
}

TEST(Lanelet2Map, OncomingLanesToTheLeftMeanTrafficOnTheRight) {
  TwoWayRoad road;
  EXPECT_EQ(readSmall(road.osm.text()).map.driving_side, DrivingSide::kRight);
}

TEST(Lanelet2Map, OncomingLanesToTheRightMeanTrafficOnTheLeft) {
  SmallLanelet2 osm;
  const std::string between = osm.line({{0.0, 0.0}, {20.0, 0.0}});
  const std::string west =
      osm.lanelet(osm.line({{20.0, -3.0}, {0.0, -3.0}}), between, "road", tag("one_way", "yes"));
  osm.lanelet(osm.line({{0.0, 3.0}, {20.0, 3.0}}), between);
  EXPECT_EQ(readSmall(osm.text()).map.driving_side, DrivingSide::kLeft);
}

TEST(Lanelet2Map, TheConfiguredSideComesFirstAndAMapWithoutOneWarns) {
  DataOptions options = mapOptions();
  options.locations["tow"] = DrivingSide::kLeft;
  EXPECT_EQ(readSmall(TwoWayRoad().osm.text(), options).map.driving_side, DrivingSide::kLeft);
  SmallLanelet2 osm;
  osm.lanelet(osm.line({{0.0, 3.0}, {9.0, 3.0}}), osm.line({{0.0, 0.0}, {9.0, 0.0}}));
  EXPECT_THAT(readSmall(osm.text()).warnings, ElementsAre(HasSubstr("set it in locations.yaml")));
}

TEST(Lanelet2Map, ALaneOfBothDirectionsBecomesTwo) {
  SmallLanelet2 osm;
  const std::string id =
      osm.lanelet(osm.line({{0.0, 3.0}, {9.0, 3.0}}), osm.line({{0.0, 0.0}, {9.0, 0.0}}), "road",
                  tag("one_way", "no"));
  const ReadMap read = readSmall(osm.text());
  ASSERT_EQ(read.map.lanes.size(), 2U);
  EXPECT_NEAR(read.lane(id).centerline.front().x, 0.0, 1e-9);
  EXPECT_NEAR(read.lane(id + kReverse).centerline.front().x, 9.0, 1e-9);
  EXPECT_EQ(read.map.drivable_area.size(), 1U);
}

TEST(Lanelet2Map, ACentrelineInABendIsWithinFiveCentimetres) {
  for (const std::size_t pieces : {40U, 29U}) {
    SmallLanelet2 osm;
    const std::string left = osm.line(arc(10.0, 40));
    const std::string right = osm.line(arc(13.5, pieces));
    const ReadMap read = readSmall((osm.lanelet(left, right), osm.text()));
    EXPECT_LT(farthest(read.map.lanes.at(0), arc(11.75, 400)), 0.05) << pieces;
  }
}

TEST(Lanelet2Map, ADrawnCentrelineIsTaken) {
  SmallLanelet2 osm;
  const std::string left = osm.line({{0.0, 3.0}, {9.0, 3.0}});
  const std::string right = osm.line({{0.0, 0.0}, {9.0, 0.0}});
  const std::string drawn = osm.line({{9.0, 1.0}, {0.0, 1.0}});
  osm.relation(member("left", left) + member("right", right) + member("centerline", drawn),
               tag("type", "lanelet") + tag("subtype", "road"));
  const Lane lane = readSmall(osm.text()).map.lanes.at(0);
  EXPECT_NEAR(lane.centerline.front().x, 0.0, 1e-9);
  EXPECT_NEAR(lane.centerline.front().y, 1.0, 1e-9);
}

TEST(Lanelet2Map, OnlyLaneletsForCarsAreLanesAndTheRestIsRoadOrWalkway) {
  SmallLanelet2 osm;
  const auto add = [&](const std::string& subtype, const std::string& tags = "") {
    return osm.lanelet(osm.line({{0.0, 3.0}, {9.0, 3.0}}), osm.line({{0.0, 0.0}, {9.0, 0.0}}),
                       subtype, tags);
  };
  const std::vector<std::string> lanes = {add("road"), add("highway"), add("play_street"),
                                          add("bus_lane", tag("participant:vehicle", "yes"))};
  add("bicycle_lane");
  add("road_shoulder");
  add("road", tag("participant:pedestrian", "yes"));
  add("walkway");
  add("crosswalk");
  const ReadMap read = readSmall(osm.text());
  std::vector<std::string> found;
  for (const Lane& lane : read.map.lanes) found.push_back(lane.id);
  EXPECT_EQ(found, lanes);
  EXPECT_EQ(read.map.drivable_area.size(), lanes.size() + 2);
  EXPECT_EQ(read.map.walkways.size(), 1U);
}

TEST(Lanelet2Map, AreasAreRingsOfWaysWithHoles) {
  SmallLanelet2 osm;
  osm.lanelet(osm.line({{0.0, 3.0}, {9.0, 3.0}}), osm.line({{0.0, 0.0}, {9.0, 0.0}}));
  const std::vector<std::string> corners = {osm.node({0.0, 10.0}), osm.node({9.0, 10.0}),
                                            osm.node({9.0, 19.0}), osm.node({0.0, 19.0})};
  const std::string half = osm.way({corners[0], corners[1], corners[2]});
  const std::string rest = osm.way({corners[0], corners[3], corners[2]});
  const std::vector<std::string> hole = {osm.node({4.0, 14.0}), osm.node({5.0, 14.0}),
                                         osm.node({5.0, 15.0})};
  const std::string inner = osm.way({hole[0], hole[1], hole[2], hole[0]});
  const auto area = [&](const std::string& subtype, const std::string& members) {
    return osm.relation(members, tag("type", "multipolygon") + tag("subtype", subtype));
  };
  area("parking", member("outer", half) + member("outer", rest) + member("inner", inner));
  area("walkway", member("outer", half) + member("outer", rest));
  const std::string open = area("walkway", member("outer", half));
  area("building", member("outer", half) + member("outer", rest));
  osm.way(corners, tag("type", "intersection_area") + tag("area", "yes"));
  const ReadMap read = readSmall(osm.text());
  ASSERT_EQ(read.map.drivable_area.size(), 3U);
  const Polygon& parking = read.map.drivable_area[1];
  EXPECT_TRUE(contains(parking, {1.0, 11.0}));
  EXPECT_FALSE(contains(parking, {4.7, 14.2}));
  EXPECT_TRUE(contains(read.map.drivable_area[2], {4.7, 14.2}));
  ASSERT_EQ(read.map.walkways.size(), 1U);
  EXPECT_TRUE(contains(read.map.walkways[0], {4.7, 14.2}));
  EXPECT_THAT(read.warnings,
              testing::Contains(HasSubstr("1 areas without a usable outer ring (first: " + open)));
}

TEST(Lanelet2Map, DegreesAreProjectedRelativeToTheOriginOfTheLocation) {
  SmallLanelet2 osm(false);
  osm.lanelet(osm.line({{49.0001, 8.4}, {49.0001, 8.41}}), osm.line({{49.0, 8.4}, {49.0, 8.41}}));
  EXPECT_THAT(errorOf<ConfigError>([&] { readSmall(osm.text()); }),
              HasSubstr("origins: town: [LATITUDE, LONGITUDE]"));
  const Lane lane = readSmall(osm.text(), placedOptions(), "placed").map.lanes.at(0);
  // WGS 84 at 49 degrees: 1 degree is 73,173 m along the parallel and 111,205 m along the meridian.
  const Vector2 along = lane.centerline.back().position() - lane.centerline.front().position();
  EXPECT_NEAR(along.norm(), 731.73, 0.4) << "UTM is up to 0.04 % shorter";
  EXPECT_NEAR(lane.centerline.front().position().norm(), 5.56, 0.02);
}

TEST(Lanelet2Map, ADefectCostsItsElementAndIsCounted) {
  TwoWayRoad road;
  SmallLanelet2& osm = road.osm;
  const std::string line = osm.line({{50.0, 0.0}, {60.0, 0.0}});
  const std::string one = osm.way({osm.node({1.0, 1.0})});
  osm.lanelet(line, one);
  osm.lanelet(line, "999");
  osm.relation(member("left", line), tag("type", "lanelet"));
  osm.lanelet(line, osm.line({{50.0, 3.0}, {2e5, 3.0}, {60.0, 3.0}}), "road",
              tag("speed_limit", "fast"));
  const ReadMap read = readSmall(osm.text());
  EXPECT_EQ(read.map.lanes.size(), 4U) << "the last lanelet loses one node and its speed limit";
  EXPECT_THAT(read.warnings,
              UnorderedElementsAre(HasSubstr("3 lanelets without a usable left or right bound"),
                                   HasSubstr("1 nodes beyond max_coordinate of input_limits.yaml"),
                                   HasSubstr("1 lanelets without a usable speed_limit")));
}

TEST(Lanelet2Map, DeletedElementsAreLeftOut) {
  TwoWayRoad road;
  std::string text = road.osm.text();
  replaceIn(text, "<relation id='" + road.next + "'",
            "<relation action='delete' id='" + road.next + "'");
  EXPECT_EQ(readSmall(text).map.lanes.size(), 2U);
}

TEST(Lanelet2Map, AFileWithoutLaneletsIsRefused) {
  SmallLanelet2 streets(false);
  streets.line({{49.0, 8.4}, {49.0, 8.41}}, tag("highway", "residential"));
  EXPECT_THAT(errorOf<MapError>([&] { readSmall(streets.text()); }),
              HasSubstr("town.osm: is an OpenStreetMap file without relations of type lanelet"));
  SmallLanelet2 walkway;
  walkway.lanelet(walkway.line({{0.0, 3.0}, {9.0, 3.0}}), walkway.line({{0.0, 0.0}, {9.0, 0.0}}),
                  "walkway");
  EXPECT_THAT(errorOf<MapError>([&] { readSmall(walkway.text()); }),
              HasSubstr("town.osm: is a map of the kind Lanelet2 without lanes"));
}

}  // namespace
}  // namespace forge
