#include "collision_forge/io/weights/pattern_network_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "attack/network/sample_network.h"

namespace forge {
namespace {

namespace fs = std::filesystem;

class PatternNetworkFile : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    path_ = (fs::path(testing::TempDir()) / (std::string("network_") + test->name())).string();
    PatternWeights fold = randomWeights(1);
    fold.left_out_scenes = {"scene-1", "scene-2"};
    written_ = {randomWeights(0), fold};
    writePatternWeights(written_, path_);
  }
  void TearDown() override { fs::remove_all(path_); }

  std::string content() const {
    std::stringstream text;
    text << std::ifstream(path_, std::ios::binary).rdbuf();
    return text.str();
  }

  /// Returns the error message of reading a text; "" if it succeeds.
  std::string complaintAbout(const std::string& text) const {
    std::ofstream(path_, std::ios::binary) << text;
    try {
      readPatternWeights(path_);
    } catch (const PatternNetworkFileError& error) {
      return error.what();
    }
    return "";
  }

  std::string complaintAfter(const std::string& from, const std::string& to) const {
    writePatternWeights(written_, path_);
    std::string text = content();
    const auto at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return complaintAbout(text.replace(at, from.size(), to));
  }

  std::string path_;
  std::vector<PatternWeights> written_;
};

TEST_F(PatternNetworkFile, RoundTripsNetworks) {
  const auto read = readPatternWeights(path_);
  ASSERT_EQ(read.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(read[i].left_out_scenes, written_[i].left_out_scenes);
    EXPECT_EQ(read[i].network.scene, written_[i].network.scene);
    EXPECT_EQ(read[i].features.head, written_[i].features.head);
    EXPECT_EQ(read[i].features.spacing_rate, written_[i].features.spacing_rate);
    EXPECT_EQ(read[i].features.encoding.lane_points, written_[i].features.encoding.lane_points);
    for (const auto& [name, layer] : written_[i].layers) {
      EXPECT_EQ(read[i].layers.at(name).matrix, layer.matrix) << name;
      EXPECT_EQ(read[i].layers.at(name).bias, layer.bias) << name;
    }
  }
}

TEST_F(PatternNetworkFile, RoundTripsBytes) {
  const std::string before = content();
  writePatternWeights(readPatternWeights(path_), path_);
  EXPECT_EQ(content(), before);
  EXPECT_FALSE(fs::exists(path_ + ".part"));
}

TEST_F(PatternNetworkFile, RejectsATruncatedFile) {
  const std::string text = content();
  const std::string complaint = complaintAbout(text.substr(0, text.size() - 3));
  EXPECT_NE(complaint.find(path_ + ": network 2: the file ends within layer value"),
            std::string::npos)
      << complaint;
  EXPECT_NE(complaintAbout(text.substr(0, 20)), "");
  EXPECT_NE(complaintAbout("").find("has no network"), std::string::npos);
}

TEST_F(PatternNetworkFile, RejectsOtherArchitectures) {
  EXPECT_NE(complaintAfter("network 1\"", "network 9\"").find("format"), std::string::npos);
}

TEST_F(PatternNetworkFile, RejectsAMissingFile) {
  EXPECT_THROW(readPatternWeights(path_ + ".not"), PatternNetworkFileError);
  EXPECT_THROW(loadPatternNetwork(path_ + ".not"), PatternNetworkFileError);
}

TEST_F(PatternNetworkFile, EmptyPathLoadsNoNetwork) {
  EXPECT_EQ(loadPatternNetwork(""), nullptr);
  EXPECT_EQ(loadPatternNetwork(path_)->folds().size(), 1U);
}

TEST(ShippedNetworks, AreReadWithTheirFolds) {
  const std::string folder = COLLISION_FORGE_SOURCE_DIR "/data/weights/";
  const auto networks = readPatternWeights(folder + "pattern_network.bin");
  ASSERT_GT(networks.size(), 1u);
  EXPECT_TRUE(networks[0].left_out_scenes.empty());
  for (std::size_t i = 1; i < networks.size(); ++i) {
    EXPECT_FALSE(networks[i].left_out_scenes.empty());
  }
  EXPECT_EQ(readPatternWeights(folder + "pattern_network_embedded.bin").size(), 1u);
}

}  // namespace
}  // namespace forge
