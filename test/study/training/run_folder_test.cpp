#include "collision_forge/study/training/run_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "base/files/file_size_limit.h"
#include "collision_forge/base/files/aside_file.h"
#include "io/logs/nuscenes_fixture.h"

namespace forge {
namespace {

/// Returns the difference reported for a run that is resumed with another description.
std::string differenceOf(const std::string& begun, const std::string& now) {
  const TemporaryFolder folder;
  TrainingRun run;
  run.out = folder.path() + "/run";
  { const OutputLock lock = openRunFolder(run, begun); }
  const std::string complaint =
      errorOf<std::runtime_error>([&] { static_cast<void>(openRunFolder(run, now)); });
  const std::string where = run.out + "/run.txt: ";
  EXPECT_EQ(complaint.substr(0, where.size()), where);
  const std::string remedy = "; use the same options or choose another --out";
  EXPECT_THAT(complaint, testing::EndsWith(remedy));
  return complaint.substr(where.size(), complaint.size() - where.size() - remedy.size());
}

TEST(OpenRunFolder, ResumesTheSameRun) {
  const TemporaryFolder folder;
  TrainingRun run;
  run.out = folder.path() + "/run";
  { const OutputLock lock = openRunFolder(run, "seed = 1\nfold = 2\n"); }
  EXPECT_NO_THROW(static_cast<void>(openRunFolder(run, "seed = 1\nfold = 2\n")));
}

TEST(OpenRunFolder, NamesTheFirstLineThatDiffers) {
  EXPECT_EQ(differenceOf("seed = 1\nfold = 2\nfolds = 4\n", "seed = 1\nfold = 3\nfolds = 5\n"),
            "line 2: the run was started with \"fold = 2\", not \"fold = 3\"");
}

/// Describes a run on the embedded logs; drawing.yaml stands in for a training configuration.
std::string describedWith(const std::map<std::string, std::string>& config_files) {
  TrainingRun run;
  run.sources.logs.path = COLLISION_FORGE_SOURCE_DIR "/data/embedded";
  run.sources.logs.version = "v1.0-embedded";
  run.config = COLLISION_FORGE_SOURCE_DIR "/config";
  run.config_files = config_files;
  return describeRun(run, "drawing.yaml");
}

TEST(DescribeRun, NamesTheProgramAndTheConfigurationThatResultsDependOn) {
  const std::string package = readText(COLLISION_FORGE_SOURCE_DIR "/package.xml");
  const std::size_t begin = package.find("<version>") + 9;
  const std::string version = package.substr(begin, package.find("</version>") - begin);
  const std::string text = describedWith({{"config/a.yaml", "fingerprint 1"}});
  EXPECT_THAT(text, testing::StartsWith("program = collision_forge " + version + "\n"));
  EXPECT_THAT(text, testing::HasSubstr("\nconfig/a.yaml = fingerprint 1\n"));
  EXPECT_THAT(text, testing::EndsWith(readText(COLLISION_FORGE_SOURCE_DIR "/config/drawing.yaml")));
  EXPECT_THAT(differenceOf(text, describedWith({{"config/a.yaml", "fingerprint 2"}})),
              testing::EndsWith(
                  "\"config/a.yaml = fingerprint 1\", not \"config/a.yaml = fingerprint 2\""));
  const std::string newer = "program = collision_forge 99.0.0\n" + text.substr(text.find('\n') + 1);
  EXPECT_EQ(
      differenceOf(newer, text),
      "line 1: the run was started with \"program = collision_forge 99.0.0\", not \"program = "
      "collision_forge " +
          version + "\"");
}

TEST(OpenRunFolder, IsLockedByOneRunAtATime) {
  const TemporaryFolder folder;
  TrainingRun run;
  run.out = folder.path();
  const OutputLock lock = openRunFolder(run, "seed = 1\n");
  EXPECT_THROW(static_cast<void>(openRunFolder(run, "seed = 1\n")), std::runtime_error);
}

TEST(OpenRunFolder, RejectsAStateWithoutDescription) {
  const TemporaryFolder folder;
  TrainingRun run;
  run.out = folder.path();
  writeText(statePath(run), "state");
  EXPECT_THROW(static_cast<void>(openRunFolder(run, "seed = 1\n")), std::runtime_error);
}

TEST(SplitByScene, KeepsTheSamplesOfASceneTogether) {
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

/// A run folder with three finished epochs.
class EpochTableTest : public testing::Test {
 protected:
  EpochTableTest() {
    run_.out = folder_.path();
    EpochTable table(run_, kColumns, 0);
    EXPECT_TRUE(table.add({3.0, 2.0}));
    table.keep("state of 1");
    EXPECT_FALSE(table.add({2.0, 2.5}));
    table.keep("state of 2");
    EXPECT_TRUE(table.add({1.0, 1.5}));
    table.keep("state of 3");
  }

  const std::vector<std::string> kColumns = {"loss", "validation"};
  TemporaryFolder folder_;
  TrainingRun run_;
  std::string path_ = folder_.path() + "/metrics.csv";
  std::string sums_ = folder_.path() + "/state.pt.sums";
  std::string rows_ =
      "epoch,loss,validation\n1,3.000000,2.000000\n2,2.000000,2.500000\n3,1.000000,1.500000\n";
};

TEST_F(EpochTableTest, KeepsTheRowsOfFinishedEpochs) {
  EXPECT_EQ(readText(path_), rows_);
  EpochTable again(run_, kColumns, 2);
  EXPECT_FALSE(again.add({1.0, 2.0}));
  EXPECT_EQ(readText(path_),
            "epoch,loss,validation\n1,3.000000,2.000000\n2,2.000000,2.500000\n"
            "3,1.000000,2.000000\n");
  EXPECT_EQ(again.lastRow(), "3,1.000000,2.000000");
}

TEST_F(EpochTableTest, ResumesAfterAKillBetweenTwoFiles) {
  const std::string sums = readText(sums_);
  EpochTable(run_, kColumns, 3).add({1.0, 1.0});  // the row exists, its checksum does not
  EXPECT_TRUE(hasState(run_));
  EpochTable table(run_, kColumns, 3);
  table.add({1.0, 1.0});
  table.keep("state of 4");
  writeText(statePath(run_), "state of 3");  // row and checksum exist, the state does not
  EXPECT_TRUE(hasState(run_));
  EpochTable again(run_, kColumns, 3);
  again.add({1.0, 1.0});
  again.keep("state of 4");
  EXPECT_TRUE(hasState(run_));
  EXPECT_EQ(readText(path_), rows_ + "4,1.000000,1.000000\n");
  EXPECT_EQ(readText(sums_).substr(0, sums.size()), sums);
  EXPECT_EQ(readText(sums_).size(), sums.size() / 3 * 4);
}

TEST_F(EpochTableTest, AnAlteredStateIsRejected) {
  EXPECT_TRUE(hasState(run_));
  const std::string refusal = statePath(run_) + ": the file was changed: ";
  std::string flipped = "state of 3";
  flipped[4] ^= 1;
  for (const std::string& altered : {flipped, std::string("state of"), std::string()}) {
    writeText(statePath(run_), altered);
    EXPECT_THAT(errorOf<std::runtime_error>([&] { hasState(run_); }), testing::StartsWith(refusal))
        << altered;
  }
  writeText(statePath(run_), "state of 3");
  std::filesystem::remove(sums_);
  EXPECT_THAT(errorOf<std::runtime_error>([&] { hasState(run_); }), testing::StartsWith(refusal));
  std::filesystem::remove(statePath(run_));
  EXPECT_FALSE(hasState(run_));
}

}  // namespace
}  // namespace forge
