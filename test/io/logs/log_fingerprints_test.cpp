#include "collision_forge/io/logs/log_fingerprints.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/logs/nuscenes_fixture.h"

namespace forge {
namespace {

using testing::ElementsAre;
using testing::Key;

TEST(LogFingerprints, CoverTablesAndMapsOfANuScenesRoot) {
  const TemporaryFolder folder;
  folder.write("v1.0-tiny/scene.json", "[1]");
  folder.write("v1.0-other/scene.json", "[1]");
  folder.write("maps/expansion/town.json", "{}");
  folder.write("samples/LIDAR_TOP/one.bin", "points");
  const auto before = logFingerprints(folder.path(), "v1.0-tiny");
  EXPECT_THAT(before, ElementsAre(Key("maps"), Key("tables")));
  EXPECT_THAT(logFingerprints(folder.path(), ""), ElementsAre(Key("maps")));
  folder.write("v1.0-other/scene.json", "[2]");
  folder.write("samples/LIDAR_TOP/one.bin", "others");
  EXPECT_EQ(logFingerprints(folder.path(), "v1.0-tiny"), before);
  folder.write("v1.0-tiny/scene.json", "[2]");
  EXPECT_NE(logFingerprints(folder.path(), "v1.0-tiny").at("tables"), before.at("tables"));
  folder.write("maps/expansion/town.json", "[]");
  EXPECT_NE(logFingerprints(folder.path(), "v1.0-tiny").at("maps"), before.at("maps"));
}

TEST(LogFingerprints, CoverAllFilesOfOtherSources) {
  const TemporaryFolder folder;
  const std::string bag = folder.write("bags/one.bag", "1");
  const auto before = logFingerprints(folder.path() + "/bags", "");
  EXPECT_THAT(before, ElementsAre(Key("logs")));
  EXPECT_THAT(logFingerprints(bag, ""), ElementsAre(Key("logs")));
  folder.write("bags/one.bag", "2");
  EXPECT_NE(logFingerprints(folder.path() + "/bags", ""), before);
}

}  // namespace
}  // namespace forge
