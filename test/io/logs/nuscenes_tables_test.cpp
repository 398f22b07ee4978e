#include "collision_forge/io/logs/nuscenes_tables.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/logs/nuscenes_fixture.h"

namespace forge {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

NuScenesRoot tinyRoot(const TemporaryFolder& folder, const std::vector<std::string>& only = {}) {
  writeTables(folder, tinyTables());
  NuScenesReadOptions options;
  options.only = only;
  return NuScenesRoot(folder.path(), "v1.0-tiny", options);
}

TEST(NuScenesTables, readsASceneExactly) {
  const TemporaryFolder folder;
  const NuScenesRoot root = tinyRoot(folder);
  EXPECT_THAT(root.sceneNames(), ElementsAre("scene-0001", "scene-0002"));

  const NuScenesRecording recording = root.readScene("scene-0001");
  EXPECT_EQ(recording.name, "scene-0001");
  EXPECT_EQ(recording.description, "A car");
  EXPECT_EQ(recording.location, "left-town");
  ASSERT_EQ(recording.frames.size(), 3U);
  EXPECT_EQ(recording.frames[0].token, "f0");
  EXPECT_EQ(recording.frames[0].timestamp_us, 1533000000000001);
  EXPECT_EQ(recording.frames[2].timestamp_us, 1533000001000000);
  ASSERT_EQ(recording.frames[1].annotations.size(), 2U);
  const NuScenesAnnotation& car = recording.frames[0].annotations.at(0);
  EXPECT_EQ(car.token, "a0");
  EXPECT_EQ(car.instance, kHexToken);
  EXPECT_EQ(car.category, "vehicle.car");
  EXPECT_THAT(car.attributes, ElementsAre("vehicle.moving"));
  EXPECT_EQ(car.translation, Eigen::Vector3d(10.0, 50.0, 1.0));
  EXPECT_EQ(car.size, Eigen::Vector3d(4.5, 2.0, 1.6)) << "length, width, height";
  const NuScenesAnnotation& pedestrian = recording.frames[1].annotations.at(1);
  EXPECT_EQ(pedestrian.category, "human.pedestrian.adult");
  EXPECT_TRUE(pedestrian.attributes.empty());
  EXPECT_DOUBLE_EQ(pedestrian.rotation.norm(), 1.0);
}

TEST(NuScenesTables, takesOnlyLidarPosesInOrderOfTime) {
  const TemporaryFolder folder;
  const NuScenesRecording recording = tinyRoot(folder).readScene("scene-0001");
  ASSERT_EQ(recording.ego_poses.size(), 3U);
  EXPECT_EQ(recording.ego_poses[0].timestamp_us, 1533000000000001);
  EXPECT_EQ(recording.ego_poses[1].translation, Eigen::Vector3d(100.0, 204.0, 0.0));
  EXPECT_EQ(recording.ego_poses[2].timestamp_us, 1533000001000001);
  EXPECT_NEAR(recording.ego_poses[2].rotation.w(), 0.7071067811865476, 1e-15);
}

TEST(NuScenesTables, rowsOfOtherScenesAreNotChecked) {
  const TemporaryFolder folder;
  auto tables = tinyTables();
  replaceIn(tables["sample_annotation"], "[2.0, 4.5, 1.6]", "[0, 0, 0]");
  writeTables(folder, tables);
  NuScenesReadOptions options;
  options.only = {"scene-0002"};
  const NuScenesRoot root(folder.path(), "v1.0-tiny", options);
  EXPECT_EQ(root.readScene("scene-0002").frames.size(), 1U);
  EXPECT_THAT(errorOf([&] { root.readScene("scene-0001"); }),
              HasSubstr("scene-0001 is not among the selected scenes"));
}

TEST(NuScenesTables, namesTheNearestScenes) {
  const TemporaryFolder folder;
  const NuScenesRoot root = tinyRoot(folder);
  const std::string error = errorOf([&] { root.readScene("scene-002"); });
  EXPECT_THAT(error, HasSubstr("scene.json"));
  EXPECT_THAT(error, HasSubstr("'scene-002'"));
  EXPECT_THAT(error, HasSubstr("the most similar of 2: scene-0002 scene-0001"));
  EXPECT_EQ(errorOf([&] { tinyRoot(folder, {"scene-002"}); }), error);
}

TEST(NuScenesTables, namesAMissingFolderAndEveryMissingTable) {
  const TemporaryFolder folder;
  writeTables(folder, tinyTables());
  const auto read = [&](const std::string& version) {
    return errorOf([&] { NuScenesRoot(folder.path(), version); });
  };
  EXPECT_THAT(read("v1.0-none"), HasSubstr("v1.0-none: no such folder"));
  for (const auto& [table, content] : tinyTables()) {
    const std::string path = folder.path() + "/v1.0-tiny/" + table + ".json";
    std::filesystem::remove(path);
    EXPECT_THAT(read("v1.0-tiny"), HasSubstr(path + ": cannot be read: No such file"));
    folder.write("v1.0-tiny/" + table + ".json", content);
  }
  EXPECT_EQ(read("v1.0-tiny"), "");
}

}  // namespace
}  // namespace forge
