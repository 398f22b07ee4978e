#include "collision_forge/planner_test/settings/config_fingerprint.h"

#include <gtest/gtest.h>

#include "io/logs/nuscenes_fixture.h"

namespace forge {
namespace {

using Fingerprints = std::map<std::string, std::string>;

TEST(FingerprintsOf, ContainEveryYamlFileThatAffectsResults) {
  const TemporaryFolder folder;
  folder.write("b.yaml", "a");
  folder.write("a.yaml", "foobar");
  folder.write("attacked_bag.yaml", "a");
  folder.write("drawing.yaml", "a");
  folder.write("report.yaml", "a");
  folder.write("topics_mine.yaml", "a");
  folder.write("tuning.yaml", "a");
  folder.write("notes.txt", "a");
  EXPECT_EQ(fingerprintsOf({}, folder.path()),
            (Fingerprints{{"config/a.yaml", "fingerprint 85944171f73967e8"},
                          {"config/b.yaml", "fingerprint af63dc4c8601ec8c"}}));
}

TEST(FingerprintsOf, ContainTheContentOfModels) {
  const TemporaryFolder folder;
  const TemporaryFolder models;
  models.write("speeds.jsonl", "a");
  models.write("network.bin", "foobar");
  Config config;
  config.speed_model = models.path() + "/speeds.jsonl";
  config.pattern_network = models.path() + "/network.bin";
  EXPECT_EQ(fingerprintsOf(config, folder.path()),
            (Fingerprints{{"speed_model", "fingerprint af63dc4c8601ec8c"},
                          {"pattern_network", "fingerprint 85944171f73967e8"}}));
}

/// Input beyond the limits is skipped, so the limits affect results.
TEST(FingerprintsOf, ContainTheInputLimits) {
  const TemporaryFolder folder;
  folder.write("input_limits.yaml", "a");
  EXPECT_EQ(fingerprintsOf({}, folder.path()).count("config/input_limits.yaml"), 1U);
}

TEST(ConfigFingerprints, ContainFilesOnly) {
  const TemporaryFolder folder;
  folder.write("a.yaml", "foobar");
  folder.write("network.bin", "foobar");
  Config config;
  config.pattern_network = folder.path() + "/network.bin";
  Fingerprints all = fingerprintsOf(config, folder.path());
  EXPECT_EQ(all.erase("pattern_network"), 1u);
  EXPECT_EQ(configFingerprints(folder.path()), all);
}

TEST(FingerprintsOf, ChangeWithTheFile) {
  const TemporaryFolder folder;
  folder.write("a.yaml", "x: 1\n");
  const auto before = fingerprintsOf({}, folder.path());
  folder.write("a.yaml", "x: 2\n");
  EXPECT_NE(fingerprintsOf({}, folder.path()), before);
}

TEST(FingerprintsOf, ChangeWithAnOverlayAndNotWithComments) {
  const TemporaryFolder folder;
  const TemporaryFolder overlay;
  folder.write("a.yaml", "a: {x: 1, y: [2, 3]}\n");
  const auto before = fingerprintsOf({}, folder.path());
  overlay.write("a.yaml", "a: {x: 2}\n");
  EXPECT_NE(fingerprintsOf({}, {folder.path(), overlay.path()}), before);
  overlay.write("a.yaml", "# the same\na:\n  y: [2, 3]\n  x: 1\n");
  EXPECT_EQ(fingerprintsOf({}, {folder.path(), overlay.path()}), before);
}

TEST(FingerprintOfAll, ChangesWithNameAndContentOfAFile) {
  const TemporaryFolder folder;
  folder.write("a.yaml", "x: 1\n");
  const std::string before = fingerprintOfAll({}, folder.path());
  EXPECT_EQ(fingerprintOfAll({}, folder.path()), before);
  folder.write("a.yaml", "x: 2\n");
  EXPECT_NE(fingerprintOfAll({}, folder.path()), before);
  const TemporaryFolder other;
  other.write("b.yaml", "x: 1\n");
  EXPECT_NE(fingerprintOfAll({}, other.path()), before);
}

TEST(FingerprintsOf, RejectAMissingModel) {
  const TemporaryFolder folder;
  Config config;
  config.speed_model = folder.path() + "/absent.jsonl";
  EXPECT_THROW(fingerprintsOf(config, folder.path()), std::runtime_error);
}

}  // namespace
}  // namespace forge
