#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "collision_forge/base/files/aside_file.h"
#include "collision_forge/study/settings/study_config.h"
#include "collision_forge/study/training/run_folder.h"
#include "collision_forge/study/training/train.h"
#include "io/collide/collide_fixture.h"
#include "io/logs/nuscenes_fixture.h"

namespace forge {
namespace {

namespace fs = std::filesystem;

/// A folder with clips of six scenes, and training runs on them.
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
    const StudyConfig read = loadStudyConfig(config);
    TrainingRun run;
    run.sources.logs.path = COLLISION_FORGE_SOURCE_DIR "/data/embedded";
    run.sources.collide = folder_.path();
    run.sources.splits = {"train"};
    run.out = folder_.path() + "/" + name;
    run.config = config;
    run.options = read;
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

TEST_F(GeneratorTrainingRun, ARunKilledBetweenTwoFilesResumesToTheSameResult) {
  trainGenerator(runTo("whole", 0));
  trainGenerator(runTo("before", 1));
  fs::copy(folder_.path() + "/before", folder_.path() + "/after");
  trainGenerator(runTo("after", 0));
  const std::vector<std::string> in_order = {"/metrics.csv", "/weights.pt", "/state.pt.sums",
                                             "/state.pt"};
  for (std::size_t written = 1; written < in_order.size(); ++written) {
    const std::string killed = folder_.path() + "/killed";
    fs::remove_all(killed);
    fs::copy(folder_.path() + "/before", killed);
    for (std::size_t i = 0; i < written; ++i) {
      fs::copy_file(folder_.path() + "/after" + in_order[i], killed + in_order[i],
                    fs::copy_options::overwrite_existing);
    }
    trainGenerator(runTo("killed", 0));
    for (const char* file : {"/metrics.csv", "/weights.pt"}) {
      EXPECT_EQ(readText(folder_.path() + "/whole" + file), readText(killed + file))
          << file << " after " << in_order[written - 1];
    }
  }
}

TEST_F(GeneratorTrainingRun, ResumesOnlyFromUnchangedFiles) {
  const auto complaintWith = [&](const std::string& file, std::size_t place) {
    fs::remove_all(folder_.path() + "/run");
    trainGenerator(runTo("run", 1));
    const std::string path = folder_.path() + "/run/" + file;
    std::string bytes = readText(path);
    bytes.at(place == 0 ? bytes.size() / 2 : place) ^= 1;
    writeText(path, bytes);
    try {
      trainGenerator(runTo("run", 0));
    } catch (const std::runtime_error& error) {
      return std::string(error.what()).substr(path.size());
    }
    return std::string("no error");
  };
  EXPECT_THAT(complaintWith("state.pt", 0), testing::StartsWith(": the file was changed"));
  EXPECT_THAT(complaintWith("metrics.csv", 1), testing::StartsWith(": line 1: "));
  const std::string metrics = readText(folder_.path() + "/run/metrics.csv");
  EXPECT_THAT(complaintWith("metrics.csv", metrics.size() - 2), testing::StartsWith(": line 2: "));
  const std::string program = "program = collision_forge ";
  const std::size_t version = readText(folder_.path() + "/run/run.txt").find(program);
  EXPECT_THAT(complaintWith("run.txt", version + program.size()),
              testing::StartsWith(": line 2: the run was started with \"" + program));
}

}  // namespace
}  // namespace forge
