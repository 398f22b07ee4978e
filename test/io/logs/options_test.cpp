#include "collision_forge/io/logs/options.h"

#include <gtest/gtest.h>

#include "collision_forge/base/config/section.h"
#include "collision_forge/planner_test/settings/config.h"

namespace forge {
namespace {

const char* const kShipped = COLLISION_FORGE_SOURCE_DIR "/config";

TEST(DrivingSide, FollowsThePrefixOfTheLocation) {
  const Config config = loadConfig(kShipped);
  EXPECT_EQ(drivingSide(config, "boston-seaport"), DrivingSide::kRight);
  EXPECT_EQ(drivingSide(config, "singapore-onenorth"), DrivingSide::kLeft);
  EXPECT_EQ(drivingSide(config, "singapore"), DrivingSide::kLeft);
  EXPECT_EQ(drivingSide(config, "embedded-left"), DrivingSide::kLeft);
  EXPECT_EQ(drivingSide(config, "embedded-right-2"), DrivingSide::kRight);
}

TEST(DrivingSide, TheLongestFittingPrefixDecides) {
  DataOptions options;
  options.locations = {{"a", DrivingSide::kRight}, {"a-b", DrivingSide::kLeft}};
  EXPECT_EQ(drivingSide(options, "a-b-c"), DrivingSide::kLeft);
  EXPECT_EQ(drivingSide(options, "a-c"), DrivingSide::kRight);
}

TEST(DrivingSide, LocationsWithoutAFittingPrefixAreRefusedByName) {
  const Config config = loadConfig(kShipped);
  for (const char* location : {"las_vegas", "bost", ""}) {
    try {
      drivingSide(config, location);
      ADD_FAILURE() << location;
    } catch (const ConfigError& error) {
      EXPECT_NE(std::string(error.what()).find(location), std::string::npos);
      EXPECT_NE(std::string(error.what()).find("locations"), std::string::npos);
    }
  }
}

}  // namespace
}  // namespace forge
