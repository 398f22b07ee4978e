#include "collision_forge/io/logs/city_maps.h"

#include <gtest/gtest.h>

#include "collision_forge/base/config/config_error.h"
#include "collision_forge/io/logs/nuscenes_map.h"
#include "collision_forge/planner_test/settings/config.h"

namespace forge {
namespace {

const std::string kDataroot = COLLISION_FORGE_SOURCE_DIR "/data/embedded";

Config config() { return loadConfig(COLLISION_FORGE_SOURCE_DIR "/config"); }

TEST(CityMaps, ReadsAMapOnce) {
  CityMaps maps(kDataroot, config());
  const auto lanes = maps.at("embedded-right");
  EXPECT_EQ(lanes->map().location, "embedded-right");
  EXPECT_EQ(maps.at("embedded-right"), lanes);
  EXPECT_NE(maps.at("embedded-left"), lanes);
}

TEST(CityMaps, RejectsACityWithoutADrivingSide) {
  CityMaps maps(kDataroot, config());
  EXPECT_THROW(maps.at("atlantis"), ConfigError);
}

}  // namespace
}  // namespace forge
