#include "collision_forge/training/run_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "collision_forge/files/aside_file.h"
#include "collision_forge/settings/config.h"
#include "data/nuscenes_fixture.h"

namespace forge {
namespace {

TEST(OpenRunFolder, GoesOnWithTheSameRunAlone) {
  const TemporaryFolder folder;
  TrainingRun run;
  run.out = folder.path() + "/run";
  { const OutputLock lock = openRunFolder(run, "seed = 1\nfold = 2\n"); }
  { const OutputLock lock = openRunFolder(run, "seed = 1\nfold = 2\n"); }
  try {
    const OutputLock lock = openRunFolder(run, "seed = 1\nfold = 3\n");
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), testing::AllOf(testing::HasSubstr("\"fold = 2\""),
                                             testing::HasSubstr("\"fold = 3\"")));
  }
}

TEST(OpenRunFolder, IsOfOneRunAtATime) {
  const TemporaryFolder folder;
  TrainingRun run;
  run.out = folder.path();
  const OutputLock lock = openRunFolder(run, "seed = 1\n");
  EXPECT_THROW(static_cast<void>(openRunFolder(run, "seed = 1\n")), std::runtime_error);
}

TEST(OpenRunFolder, RefusesAStateThatNobodyDescribes) {
  const TemporaryFolder folder;
  TrainingRun run;
  run.out = folder.path();
  writeText(statePath(run), "state");
  EXPECT_THROW(static_cast<void>(openRunFolder(run, "seed = 1\n")), std::runtime_error);
}

TEST(SplitByScene, KeepsAScenesSamplesTogether) {
  std::vector<std::string> scenes;
  for (int i = 0; i < 60; ++i) scenes.push_back("scene-" + std::to_string(i % 20));
  const SampleSplit split = splitByScene(scenes, 0.1, 3);
  EXPECT_EQ(split.training.size() + split.validation.size(), scenes.size());
  EXPECT_EQ(split.validation.size(), 6u);
  for (const std::size_t a : split.validation) {
    for (const std::size_t b : split.training) EXPECT_NE(scenes[a], scenes[b]);
  }
  EXPECT_TRUE(splitByScene(scenes, 0.0, 3).validation.empty());
}

TEST(EpochTable, KeepsTheRowsOfEpochsThatAreDone) {
  const TemporaryFolder folder;
  const std::string path = folder.path() + "/metrics.csv";
  EpochTable table(path, {"loss", "validation"}, 0);
  EXPECT_TRUE(table.add({3.0, 2.0}));
  EXPECT_FALSE(table.add({2.0, 2.5}));
  EXPECT_TRUE(table.add({1.0, 1.5}));
  EpochTable again(path, {"loss", "validation"}, 2);
  EXPECT_FALSE(again.add({1.0, 2.0}));
  EXPECT_EQ(readText(path),
            "epoch,loss,validation\n1,3.000000,2.000000\n2,2.000000,2.500000\n"
            "3,1.000000,2.000000\n");
  EXPECT_EQ(again.lastRow(), "3,1.000000,2.000000");
  const Config config = loadConfig(COLLISION_FORGE_SOURCE_DIR "/config");
  again.drawCurves(folder.path() + "/curves.png", "A training",
                   {{"loss", "training"}, {"validation", "validation"}}, config.drawing);
  EXPECT_TRUE(std::filesystem::exists(folder.path() + "/curves.png"));
}

}  // namespace
}  // namespace forge
