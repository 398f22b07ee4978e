#include "collision_forge/study/generators/generator_file.h"
#include "collision_forge/study/generators/make_traffic_model.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "collision_forge/base/config/config_folder.h"
#include "collision_forge/base/files/aside_file.h"
#include "collision_forge/study/generators/traffic_generator.h"
#include "io/logs/nuscenes_fixture.h"
#include "study/generators/sample_traffic.h"

namespace forge {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

std::string configText() {
  return ConfigFolder(COLLISION_FORGE_SOURCE_DIR "/config")
      .textOfSections(configFileOf("c_sgan"), sectionsOf("c_sgan"));
}

std::shared_ptr<TrafficGenerator> made(const GeneratorOptions& options, std::uint64_t seed) {
  return std::dynamic_pointer_cast<TrafficGenerator>(
      makeTrafficModel("c_sgan", options, torch::kCPU, seed));
}

class GeneratorFile : public testing::Test {
 protected:
  GeneratorFile() : path_(folder_.path() + "/weights.pt") {}

  std::shared_ptr<const TrafficMethods> loaded(const std::string& name) const {
    std::shared_ptr<const TrafficMethods> methods;
    forgeLoadGenerator(name, {path_}, methods);
    return methods;
  }

  std::string refusal(const std::string& name = "c_sgan") const {
    try {
      loaded(name);
      return "";
    } catch (const TrafficGeneratorError& error) {
      return error.what();
    } catch (const ConfigError& error) {  // of the text in its header
      return error.what();
    }
  }

  GeneratorHeader header_{"c_sgan", configText(), 8, 3, {"scene-0001"}};
  GeneratorOptions options_ = optionsOf(header_, "generators.yaml");
  std::shared_ptr<TrafficGenerator> generator_ = made(options_, 0);
  TemporaryFolder folder_;
  std::string path_;
};

TEST_F(GeneratorFile, RoundTrips) {
  writeText(path_, generatorBytes(header_, *generator_, false));
  const GeneratorHeader header = readGeneratorHeader(path_, "c_sgan");
  EXPECT_EQ(header.config, header_.config);
  EXPECT_EQ(header.epochs, 3);
  EXPECT_EQ(header.left_out_scenes, header_.left_out_scenes);
  const auto other = made(optionsOf(header, path_), 77);
  readGenerator(path_, *other, false);
  const std::vector<TrafficClip> clips = sampleClips(options_.traffic, 2);
  const TrafficBatch history =
      historyOf(sampleBatch(clips, options_.traffic), options_.traffic.history_frames);
  EXPECT_TRUE(
      torch::equal(generator_->predict(history, noiseOf(5)), other->predict(history, noiseOf(5))));
  EXPECT_NE(loaded("c_sgan"), nullptr);
}

TEST_F(GeneratorFile, ResumedTrainingEqualsUninterruptedTraining) {
  const std::vector<TrafficClip> clips = sampleClips(options_.traffic, 2);
  const TrafficBatch batch = sampleBatch(clips, options_.traffic);
  for (int step = 0; step < 4; ++step) generator_->trainStep(batch);
  writeText(path_, generatorBytes(header_, *generator_, true));
  const auto other = made(options_, 77);
  readGenerator(path_, *other, true);
  const auto goOn = [&](TrafficGenerator& generator) {
    torch::manual_seed(9);
    for (int step = 0; step < 3; ++step) generator.trainStep(batch);
    return driveError(generator, batch, options_.traffic);
  };
  EXPECT_EQ(goOn(*generator_), goOn(*other));
}

TEST_F(GeneratorFile, AnotherGeneratorIsRejected) {
  GeneratorHeader header = header_;
  header.name = "c_other";
  writeText(path_, generatorBytes(header, *generator_, false));
  EXPECT_THAT(refusal(), AllOf(HasSubstr(path_), HasSubstr("c_other, not c_sgan")));
}

TEST_F(GeneratorFile, SizesOutOfBoundsAreRejected) {
  const auto refusalOf = [&](const std::string& field, const std::string& value) {
    GeneratorHeader header = header_;
    const std::size_t begin = header.config.find(field + ": ") + field.size() + 2;
    header.config.replace(begin, header.config.find('\n', begin) - begin, value);
    writeText(path_, generatorBytes(header, *generator_, false));
    return refusal();
  };
  EXPECT_THAT(refusalOf("encoder", "2000000"), StartsWith(path_ + ": c_sgan.encoder = 2000000 is"));
  EXPECT_THAT(refusalOf("max_agents", "2000000"), StartsWith(path_ + ": traffic.max_agents = 20"));
  EXPECT_THAT(refusalOf("noise", "33"), StartsWith(path_ + ": c_sgan.noise"));
  for (const int frames : {0, -1, 2000000000}) {
    header_.history_frames = frames;
    writeText(path_, generatorBytes(header_, *generator_, false));
    EXPECT_THAT(refusal(), AllOf(StartsWith(path_), HasSubstr("history_frames = ")));
  }
}

TEST_F(GeneratorFile, InvalidFilesAreRejectedWithAOneLineMessage) {
  EXPECT_THAT(refusal(), AllOf(HasSubstr(path_), testing::Not(HasSubstr("\n"))));
  writeText(path_, "no archive");
  EXPECT_THAT(refusal(), AllOf(HasSubstr(path_), testing::Not(HasSubstr("\n"))));
}

}  // namespace
}  // namespace forge
