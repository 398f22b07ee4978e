#include "collision_forge/io/collide/collide_set.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "collision_forge/io/collide/collide_clip.h"
#include "io/collide/collide_fixture.h"
#include "io/logs/nuscenes_fixture.h"

namespace forge {
namespace {

std::string sceneName(int number) {
  char name[16];
  std::snprintf(name, sizeof(name), "scene-%04d", number);
  return name;
}

/// Empty files with the names of clips: scenes 1 to 60 in train, 31 to 70 in val.
void writeSplits(const TemporaryFolder& folder) {
  CollideClip clip = straightClip(CollisionType::kRearEnd, 0.0, 8, 5.0, {}, 5.0);
  for (int scene = 1; scene <= 70; ++scene) {
    clip.scene = sceneName(scene);
    clip.variant = 0;
    if (scene <= 60) folder.write("trajectory/train/" + composeCollideName(clip), "");
    clip.variant = 1;
    if (scene > 30) folder.write("trajectory/val/" + composeCollideName(clip), "");
  }
}

std::set<std::string> scenesOf(const std::vector<std::string>& paths) {
  std::set<std::string> scenes;
  for (const std::string& path : paths) scenes.insert(parseCollideName(path).scene);
  return scenes;
}

TEST(CollideSet, PublishedSplitIsTheFolderSorted) {
  const TemporaryFolder folder;
  writeSplits(folder);
  const auto paths = listCollideClips(folder.path(), "val");
  ASSERT_EQ(paths.size(), 40u);
  EXPECT_TRUE(std::is_sorted(paths.begin(), paths.end()));
  EXPECT_NE(paths.front().find("/val/"), std::string::npos);
}

TEST(CollideSet, SplitBySceneDealsEveryClipOnceAndNoSceneTwice) {
  const TemporaryFolder folder;
  writeSplits(folder);
  const auto train = listCollideClipsByScene(folder.path(), "train", 0.3);
  const auto val = listCollideClipsByScene(folder.path(), "val", 0.3);
  EXPECT_EQ(train.size() + val.size(), 100u);
  const auto train_scenes = scenesOf(train);
  for (const std::string& scene : scenesOf(val)) EXPECT_EQ(train_scenes.count(scene), 0u) << scene;
  EXPECT_GT(val.size(), 10u);
  EXPECT_LT(val.size(), 60u);
  EXPECT_THROW(listCollideClipsByScene(folder.path(), "test", 0.3), std::invalid_argument);
  EXPECT_THROW(listCollideClipsByScene(folder.path(), "val", 0.0), CollideError);
}

TEST(CollideSet, HalvesHoldEveryClipOnceAndEveryOtherScene) {
  const TemporaryFolder folder;
  writeSplits(folder);
  auto paths = listCollideClips(folder.path(), "train");
  const auto more = listCollideClips(folder.path(), "val");
  paths.insert(paths.end(), more.begin(), more.end());
  const ClipHalves halves = halvesByScene(paths);
  EXPECT_EQ(halves.first.size() + halves.second.size(), paths.size());
  std::set<std::string> odd, even;
  for (int scene = 1; scene <= 70; ++scene) (scene % 2 ? odd : even).insert(sceneName(scene));
  EXPECT_EQ(scenesOf(halves.first), odd);
  EXPECT_EQ(scenesOf(halves.second), even);
  EXPECT_THROW(halvesByScene({paths.front()}), CollideError);
  EXPECT_THROW(halvesByScene({}), CollideError);
}

TEST(CollideSet, AbsentAndEmptyFoldersAndOtherFilesAreErrors) {
  const TemporaryFolder folder;
  EXPECT_THROW(listCollideClips(folder.path(), "val"), CollideError);
  std::filesystem::create_directories(folder.path() + "/trajectory/val");
  EXPECT_THROW(listCollideClips(folder.path(), "val"), CollideError);
  folder.write("trajectory/val/notes.txt", "");
  EXPECT_THROW(listCollideClips(folder.path(), "val"), CollideError);
}

}  // namespace
}  // namespace forge
