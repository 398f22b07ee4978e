#include "collision_forge/io/weights/traffic_generators.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "io/logs/nuscenes_fixture.h"

namespace forge {
namespace {

/// Returns the generator weights of a configuration with this text.
class GeneratorWeights : public testing::Test {
 protected:
  GeneratorWeights() {
    std::filesystem::create_directory(folder_.path() + "/study");
    options_.folder = folder_.path();
  }

  void write(const std::string& text) {
    folder_.write("study/generator_weights.yaml", text);
    addGeneratorMethods(options_, registry_);
  }

  std::string refusal(const std::string& method) const {
    try {
      registry_.at(method).make({});
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  }

  TemporaryFolder folder_;
  ModelOptions options_;
  MethodRegistry registry_;
};

TEST_F(GeneratorWeights, AreNotNeededToListTheMethods) {
  addGeneratorMethods(options_, registry_);
  EXPECT_THAT(registry_.names(),
              testing::IsSupersetOf({"c_mid", "c_sgan", "c_strive", "published_network"}));
  EXPECT_TRUE(registry_.at("c_sgan").is_seeded);
}

TEST_F(GeneratorWeights, AModelWithoutAFileIsRejectedByName) {
  write("c_sgan: []\n");
  EXPECT_THAT(refusal("c_sgan"),
              testing::HasSubstr("c_sgan has no file in study/generator_weights.yaml"));
}

TEST_F(GeneratorWeights, NonCommercialOnesAreRejectedNamingTheKey) {
  options_.non_commercial_weights = false;
  folder_.write("study/non_commercial.txt", "mine.pt\n");
  write("c_sgan: [mine.pt]\n");
  EXPECT_EQ(refusal("c_sgan"),
            "c_sgan needs weights that models.non_commercial_weights in models.yaml: false "
            "excludes");
}

}  // namespace
}  // namespace forge
