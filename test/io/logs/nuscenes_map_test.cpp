#include "collision_forge/io/logs/nuscenes_map.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/scene/shipped_limits.h"
#include "io/logs/map_fixture.h"
#include "io/logs/nuscenes_fixture.h"

namespace forge {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

struct Result {
  LaneMap map;
  std::vector<std::string> warnings;
};

Result readTiny(const std::string& content, double resolution = 1.0) {
  const TemporaryFolder folder;
  folder.write("maps/expansion/tiny-town.json", content);
  Result result;
  result.map = readNuScenesMap(folder.path(), "tiny-town", DrivingSide::kLeft,
                               {resolution, shippedLimits()}, &result.warnings);
  return result;
}

Result readDamaged(const std::string& from, const std::string& to) {
  std::string content = tinyMap();
  replaceIn(content, from, to);
  return readTiny(content);
}

const Lane& laneOf(const LaneMap& map, const std::string& id) {
  for (const Lane& lane : map.lanes) {
    if (lane.id == id) return lane;
  }
  throw std::logic_error("no lane " + id);
}

TEST(NuScenesMap, readsLanesConnectorsAndArea) {
  const Result result = readTiny(tinyMap());
  const LaneMap& map = result.map;
  EXPECT_EQ(map.location, "tiny-town");
  EXPECT_EQ(map.driving_side, DrivingSide::kLeft);
  ASSERT_EQ(map.lanes.size(), 3U);
  const Lane& a = laneOf(map, "a");
  EXPECT_FALSE(a.is_connector);
  EXPECT_FALSE(a.is_intersection);
  EXPECT_EQ(a.polygon.size(), 4U) << "open ring without repeated nodes";
  EXPECT_NEAR(a.centerline.front().x, 0.0, 1e-9);
  EXPECT_NEAR(a.centerline.back().x, 10.0, 1e-9);
  const Lane& b = laneOf(map, "b");
  EXPECT_TRUE(b.is_connector);
  EXPECT_TRUE(b.is_intersection);
  const Pose2& end_of_turn = laneOf(map, "c").centerline.back();
  EXPECT_NEAR(end_of_turn.x, 30.0, 1e-9);
  EXPECT_NEAR(end_of_turn.y, 10.0, 1e-9);
  EXPECT_NEAR(end_of_turn.yaw, std::acos(0.0), 1e-9);
  ASSERT_EQ(map.drivable_area.size(), 1U);
  EXPECT_TRUE(contains(map.drivable_area[0], {5.0, 0.0}));
  EXPECT_FALSE(contains(map.drivable_area[0], {1.8, 0.0})) << "in the hole";
  ASSERT_EQ(map.walkways.size(), 1U);
  EXPECT_TRUE(contains(map.walkways[0], {15.0, 0.0}));
}

TEST(NuScenesMap, carParksAreDrivable) {
  std::string content = tinyMap();
  replaceIn(content, R"("walkway": [)",
            R"("carpark_area": [{"token": "k", "polygon_token": "pb"}], "walkway": [)");
  const LaneMap map = readTiny(content).map;
  ASSERT_EQ(map.drivable_area.size(), 2U);
  EXPECT_TRUE(contains(map.drivable_area[1], {15.0, 0.0}));
}

TEST(NuScenesMap, resolutionSetsThePosesOfACenterline) {
  const auto fine = laneOf(readTiny(tinyMap(), 0.5).map, "a").centerline;
  const auto coarse = laneOf(readTiny(tinyMap(), 2.0).map, "a").centerline;
  EXPECT_GT(fine.size(), 20U);
  EXPECT_LT(coarse.size(), 8U);
  EXPECT_THROW(readTiny(tinyMap(), 0.0), std::invalid_argument);
  EXPECT_THROW(readTiny(tinyMap(), std::nan("")), std::invalid_argument);
}

TEST(NuScenesMap, refusesOldVersionsAndNamesThem) {
  for (const char* version : {"1.2", "1.0", "0.9", "newest", ""}) {
    const std::string error =
        errorOf([&] { readDamaged(R"("1.3")", "\"" + std::string(version) + "\""); });
    EXPECT_THAT(error, HasSubstr("maps/expansion/tiny-town.json: field version is '" +
                                 std::string(version) + "'"));
  }
  EXPECT_THAT(errorOf([&] { readDamaged(R"("version": "1.3",)", ""); }),
              HasSubstr("tiny-town.json: field version is missing"));
  EXPECT_THAT(errorOf([&] { readDamaged(R"("1.3")", "1.3"); }),
              HasSubstr("tiny-town.json: field version is not a string"));
  for (const char* version : {R"("1.10")", R"("2.0")", R"("1.3.1")"}) {
    EXPECT_EQ(readDamaged(R"("1.3")", version).map.lanes.size(), 3U) << version;
  }
}

/// A defect of the published maps, and the expected warning.
struct Defect {
  std::string name;
  std::string from;
  std::string to;
  std::string warning;
};

void PrintTo(const Defect& defect, std::ostream* out) { *out << defect.name; }

class DefectiveNuScenesMap : public ::testing::TestWithParam<Defect> {};

TEST_P(DefectiveNuScenesMap, isReadWithOneWarning) {
  const Result sound = readTiny(tinyMap());
  ASSERT_THAT(sound.warnings,
              ElementsAre(HasSubstr("1 lanes without a usable polygon (first: c)")));
  const Result result = readDamaged(GetParam().from, GetParam().to);
  EXPECT_EQ(result.map.lanes.size(), 3U);
  EXPECT_THAT(result.warnings, testing::Contains(HasSubstr(GetParam().warning)));
  for (const Lane& lane : result.map.lanes) {
    for (const Pose2& pose : lane.centerline) EXPECT_TRUE(pose.isFinite());
    for (const std::string& id : lane.outgoing) laneOf(result.map, id);
    for (const std::string& id : lane.incoming) laneOf(result.map, id);
  }
}

const Defect kDefects[] = {
    {"linkToNowhere", R"("outgoing": ["b"])", R"("outgoing": ["b", "gone", "gone2"])",
     "2 links to or from lanes that do not exist (first: gone)"},
    {"linksOfNoLane", R"("connectivity": {)", R"("connectivity": {"z": {"incoming": [],
     "outgoing": []}, )",
     "1 links to or from lanes that do not exist (first: z)"},
    {"noLinks", R"("outgoing": ["b"])", R"("outgoing": [])",
     "1 lanes and connectors without any link (first: a)"},
    {"noArcline", R"("b": [{"start)", R"("B": [{"start)",
     "1 lane connectors without a usable arcline (first: b)"},
    {"emptyArcline", R"("a": [{"start)", R"("a": [], "other": [{"start)",
     "1 lanes without a usable arcline (first: a)"},
    {"nanArcline", "[10, 0, 0], \"shape\": \"LSL\"", "[10, NaN, 0], \"shape\": \"LSL\"",
     "1 unusable arclines (number out of range, or unknown shape) (first: b)"},
    {"nanLength", "[15.707963267948966, 0, 0]", "[NaN, 0, 0]", "1 unusable arclines"},
    {"farLength", "[15.707963267948966, 0, 0]", "[1e9, 0, 0]", "1 unusable arclines"},
    {"negativeLength", "[15.707963267948966, 0, 0]", "[-1, 0, 0]", "1 unusable arclines"},
    {"longLine", "[15.707963267948966, 0, 0]", "[40000, 0, 0]",
     "1 lanes without a usable arcline (first: c)"},
    {"tinyRadius", "\"radius\": 10.0", "\"radius\": 1e-308", "1 unusable arclines"},
    {"zeroRadius", "\"radius\": 10.0", "\"radius\": 0", "1 unusable arclines"},
    {"unknownShape", "\"LSR\"", "\"LXR\"", "1 unusable arclines"},
    {"connectorWithoutPolygon", R"({"token": "b", "polygon_token": "pb"})", R"({"token": "b"})",
     "1 lane connectors without a usable polygon (first: b)"},
    {"nullPolygon", R"("polygon_token": "pb"}],
    "connectivity")",
     R"("polygon_token": null}],
    "connectivity")",
     "1 lane connectors without a usable polygon (first: b)"},
    {"twoNodes", R"(["n1", "n4", "n5", "n2"])", R"(["n1", "n4", "n1"])",
     "1 degenerate polygons (first: pb)"},
    {"farPolygon", R"("n5", "x": 20, "y": 2)", R"("n5", "x": 20, "y": 1e9)",
     "2 degenerate polygons (first: pb)"},
    {"flatPolygon", R"("n5", "x": 20, "y": 2)", R"("n5", "x": 20, "y": NaN)",
     "2 degenerate polygons (first: pb)"},
    {"unknownNode", R"(["n1", "n4", "n5", "n2"])", R"(["n1", "n4", "n5", "n99"])",
     "1 degenerate polygons (first: pb)"},
    {"flatHole", R"(["h0", "h1", "h2"])", R"(["h0", "h1"])",
     "1 degenerate holes of polygons (first: pd)"},
    {"unknownDrivable", R"("polygon_tokens": ["pd"])", R"("polygon_tokens": ["pd", "px"])",
     "1 drivable areas without a usable polygon (first: px)"},
    {"nullDrivable", R"("polygon_tokens": ["pd"])", R"("polygon_tokens": ["pd", null])",
     "1 drivable areas without a usable polygon (first: )"},
};

INSTANTIATE_TEST_SUITE_P(All, DefectiveNuScenesMap, ::testing::ValuesIn(kDefects),
                         [](const auto& info) { return info.param.name; });

TEST(NuScenesMap, moreLanesOrPointsThanTheLimitsHaveAreRefused) {
  const TemporaryFolder folder;
  folder.write("maps/expansion/tiny-town.json", tinyMap());
  const auto errorWith = [&](const InputLimits& limits) -> std::string {
    try {
      readNuScenesMap(folder.path(), "tiny-town", DrivingSide::kLeft, {1.0, limits});
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(errorWith(shippedLimits()), "");
  InputLimits limits = shippedLimits();
  limits.max_lanes = 2;
  EXPECT_THAT(errorWith(limits), HasSubstr("tiny-town.json: lanes: 3 is above the limit of 2"));
  limits = shippedLimits();
  limits.max_map_points = 20;
  EXPECT_THAT(errorWith(limits), HasSubstr("tiny-town.json: points of the map"));
}

TEST(NuScenesMap, nanArclineLeavesTheLaneWithoutLine) {
  const Result result =
      readDamaged("[10, 0, 0], \"shape\": \"LSL\"", "[10, NaN, 0], \"shape\": \"LSL\"");
  EXPECT_THAT(laneOf(result.map, "b").centerline, IsEmpty());
  EXPECT_EQ(laneOf(result.map, "b").polygon.size(), 4U);
}

TEST(NuScenesMap, rowThatCannotBeUsedCostsThatRowAlone) {
  const auto warningOf = [](const std::string& from, const std::string& to) {
    const Result result = readDamaged(from, to);
    EXPECT_GE(result.map.lanes.size(), 2U) << to;
    for (const std::string& line : result.warnings) {
      if (line.find("rows of ") != std::string::npos) return line;
    }
    return std::string();
  };
  const std::string file = "maps/expansion/tiny-town.json: 1 rows of ";
  EXPECT_THAT(warningOf(R"("x": 20, "y": -2)", R"("x": "20", "y": -2)"),
              HasSubstr(file + "node that cannot be used (first: n4: field x is not a number)"));
  EXPECT_THAT(
      warningOf(R"({"token": "n4", )", "{"),
      HasSubstr(file + "node that cannot be used (first: of row 4: field token is missing)"));
  EXPECT_THAT(warningOf(R"("exterior_node_tokens")", R"("nodes")"),
              HasSubstr("polygon that cannot be used (first: pa: field exterior_node_tokens is "));
  EXPECT_THAT(
      warningOf(R"("is_intersection": true)", R"("is_intersection": 1)"),
      HasSubstr("road_segment that cannot be used (first: r: field is_intersection is nei"));
  EXPECT_THAT(
      warningOf(R"("start_pose": [0, 0, 0])", R"("start_pose": [0, 0])"),
      HasSubstr("arcline_path_3 that cannot be used (first: a: field start_pose is not an"));
  EXPECT_THAT(warningOf(R"({"token": "c"})", R"({"token": "a"})"),
              HasSubstr("lane that cannot be used (first: a: field token is a duplicate)"));
}

TEST(NuScenesMap, nullPolygonOfAWalkwayCostsThatWalkway) {
  const Result result = readDamaged(R"("walkway": [{"token": "w", "polygon_token": "pb"})",
                                    R"("walkway": [{"token": "v", "polygon_token": null},
                                                   {"token": "w", "polygon_token": "pb"})");
  EXPECT_EQ(result.map.walkways.size(), 1U);
  EXPECT_THAT(result.warnings,
              testing::Contains(HasSubstr("1 rows of walkway that cannot be used (first: v: field "
                                          "polygon_token is not a string)")));
}

TEST(NuScenesMap, namesTheMissingLayer) {
  EXPECT_THAT(errorOf([&] { readDamaged(R"("road_segment")", R"("road_segments")"); }),
              HasSubstr("maps/expansion/tiny-town.json: layer road_segment is missing"));
  EXPECT_THAT(errorOf([&] { readDamaged(R"("lane": [)", R"("lane": 3, "other": [)"); }),
              HasSubstr("maps/expansion/tiny-town.json: layer lane is not an array"));
}

TEST(NuScenesMap, namesTheByteWhereAFileIsCutOffAndAMissingFile) {
  const std::string whole = tinyMap();
  EXPECT_THAT(errorOf([&] { readTiny(whole.substr(0, 100)); }),
              HasSubstr("tiny-town.json: invalid JSON at byte 100"));
  EXPECT_THAT(errorOf([&] { readTiny(std::string(1000000, '[')); }), HasSubstr("invalid JSON"));
  EXPECT_THAT(errorOf([&] { readNuScenesMap("/nowhere", "town", DrivingSide::kRight, {}); }),
              HasSubstr("/nowhere/maps/expansion/town.json: does not exist; the folder "
                        "/nowhere/maps/expansion must contain the map expansion"));
}

TEST(NuScenesMap, namesAMapInTheFolderOfOlderVersions) {
  const TemporaryFolder folder;
  folder.write("maps/town.json", tinyMap());
  EXPECT_THAT(
      errorOf([&] { readNuScenesMap(folder.path(), "town", DrivingSide::kRight, {}); }),
      HasSubstr(folder.path() + "/maps/town.json is in the folder of version 1.2 and before"));
}

TEST(NuScenesMap, CropKeepsNearLanesAndDropsLinksToOthers) {
  const LaneMap map = readTiny(tinyMap()).map;
  const LaneMap crop = cropped(map, {{-50.0, 0.0}, {-5.0, 0.0}}, 6.0);
  ASSERT_EQ(crop.lanes.size(), 1U);
  EXPECT_EQ(crop.lanes[0].id, "a");
  EXPECT_THAT(crop.lanes[0].outgoing, IsEmpty());
  EXPECT_EQ(crop.drivable_area.size(), 1U);
  EXPECT_TRUE(crop.walkways.empty()) << "it begins at 10 m";
  EXPECT_EQ(cropped(map, {{5.0, 0.0}}, 6.0).walkways.size(), 1U);
  EXPECT_EQ(crop.location, map.location);
  EXPECT_EQ(crop.driving_side, map.driving_side);
  EXPECT_EQ(cropped(map, {{15.0, 0.0}}, 5.5).lanes.size(), 3U) << "b's links stay with a and c";
  EXPECT_TRUE(cropped(map, {{-5.0, 0.0}}, 4.9).lanes.empty());
  EXPECT_TRUE(cropped(map, {}, 1e6).lanes.empty());
}

}  // namespace
}  // namespace forge
