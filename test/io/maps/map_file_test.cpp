#include "collision_forge/io/maps/map_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "collision_forge/base/config/config_error.h"
#include "collision_forge/io/logs/nuscenes_json.h"
#include "collision_forge/io/maps/map_error.h"
#include "io/logs/map_fixture.h"
#include "io/logs/nuscenes_fixture.h"
#include "io/maps/map_options.h"

namespace forge {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

DataOptions optionsOf(const std::string& location, DrivingSide side) {
  DataOptions options = mapOptions();
  options.locations[location] = side;
  return options;
}

LaneMap readText(const std::string& text, const std::string& name = "town.any") {
  const TemporaryFolder folder;
  folder.write(name, text);
  return readMapFile(folder.path() + "/" + name, optionsOf("town", DrivingSide::kLeft));
}

auto refusedWith(const std::string& text) { return ThrowsMessage<MapError>(HasSubstr(text)); }

TEST(MapFile, AMapExpansionTakesItsLocationAndDrivingSideFromItsName) {
  const LaneMap map = readText(" \n" + tinyMap());
  EXPECT_EQ(map.location, "town");
  EXPECT_EQ(map.driving_side, DrivingSide::kLeft);
  EXPECT_EQ(map.lanes.size(), 3U);
  EXPECT_THAT([] { readText(tinyMap(), "nowhere.json"); },
              ThrowsMessage<ConfigError>(HasSubstr("/nowhere.json: locations.yaml: no prefix")));
}

TEST(MapFile, AnotherJsonObjectIsRefusedAsAMapExpansion) {
  EXPECT_THROW(readText(R"({"lanes": []})"), NuScenesError);
}

TEST(MapFile, OtherFilesAreNamedByTheirContentWithTheKindsThatCanBeRead) {
  EXPECT_THAT([] { readText("x,y\n1,2\n"); },
              refusedWith("is neither a JSON object nor XML; the maps that can be read are: "
                          "nuScenes map expansion ({), OpenDRIVE (<OpenDRIVE>), Lanelet2 (<osm>), "
                          "CommonRoad (<commonRoad>)"));
  EXPECT_THAT([] { readText("# Title<br>"); }, refusedWith("neither a JSON object nor XML"));
  EXPECT_THAT([] { readText("\xEF\xBB\xBF<net/>"); }, refusedWith("the root element <net>"));
  EXPECT_THAT([] { readText(""); }, refusedWith("neither a JSON object nor XML"));
  EXPECT_THAT([] { readText("<?xml version='1.0'?><net/>"); },
              refusedWith("an XML file with the root element <net>"));
  EXPECT_THAT([] { readText("<!-- c --><net>" + std::string(1 << 17, ' ') + "<lane/></net>"); },
              refusedWith("an XML file with the root element <net>"));
  EXPECT_THAT([] { readMapFile("/nowhere/town.osm", {}); },
              refusedWith("/nowhere/town.osm: cannot be opened"));
}

}  // namespace
}  // namespace forge
