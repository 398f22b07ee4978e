#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "collision_forge/settings/config.h"
#include "collision_forge/training/run_folder.h"
#include "data/collide_fixture.h"
#include "data/nuscenes_fixture.h"

namespace forge {
namespace {

namespace fs = std::filesystem;

/// A folder with clips of six scenes, and runs on them.
class GeneratorTrainingRun : public testing::Test {
 protected:
  GeneratorTrainingRun() {
    const std::string clips = folder_.path() + "/trajectory/train";
    fs::create_directories(clips);
    for (int i = 0; i < 6; ++i) {
      CollideClip clip =
          straightClip(CollisionType::kRearEnd, 0.0, 12, 5.0 + i, {-20.0, 0.1 * i, 0.0}, 9.0 + i);
      clip.scene = "scene-000" + std::to_string(i);
      writeCollideClip(clips + "/" + composeCollideName(clip), clip);
    }
  }

  TrainingRun runTo(const std::string& name, int stop_after) const {
    const std::string config = COLLISION_FORGE_SOURCE_DIR "/config";
    const Config read = loadConfig(config);
    TrainingRun run;
    run.sources.logs.path = COLLISION_FORGE_SOURCE_DIR "/data/embedded";
    run.sources.collide = folder_.path();
    run.sources.splits = {"train"};
    run.out = folder_.path() + "/" + name;
    run.config = config;
    run.options = read;
    run.drawing = read.drawing;
    run.generators = read.generators;
    run.generators.c_sgan.epochs = 2;
    run.generators.c_sgan.batch = 2;
    run.generator = "c_sgan";
    run.stop_after = stop_after;
    run.seed = 4;
    return run;
  }

  TemporaryFolder folder_;
};

TEST_F(GeneratorTrainingRun, OneThatIsStoppedGivesTheSame) {
  trainGenerator(runTo("whole", 0));
  trainGenerator(runTo("parts", 1));
  const std::string metrics = folder_.path() + "/parts/metrics.csv";
  EXPECT_THAT(readText(metrics), testing::Not(testing::HasSubstr("\n2,")));
  trainGenerator(runTo("parts", 0));
  EXPECT_THAT(readText(metrics), testing::HasSubstr("\n2,"));
  for (const char* file : {"/metrics.csv", "/weights.pt", "/curves.png"}) {
    const std::string whole = readText(folder_.path() + "/whole" + file);
    EXPECT_FALSE(whole.empty()) << file;
    EXPECT_EQ(whole, readText(folder_.path() + "/parts" + file)) << file;
  }
}

TEST_F(GeneratorTrainingRun, WithoutClipsOrOnAnAbsentDeviceIsRefused) {
  TrainingRun run = runTo("none", 0);
  run.device = "abacus";
  EXPECT_THROW(trainGenerator(run), std::runtime_error);
  run = runTo("none", 0);
  run.sources.collide.clear();
  EXPECT_THROW(trainGenerator(run), std::runtime_error);
}

}  // namespace
}  // namespace forge
