#include "collision_forge/io/weights/speed_model_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "collision_forge/attack/forecast/speed_model_fit.h"
#include "collision_forge/study/settings/study_config.h"

namespace forge {
namespace {

namespace fs = std::filesystem;

const std::string kSource = COLLISION_FORGE_SOURCE_DIR;

/// Vehicles that almost keep their speed, or stand.
SpeedModel smallModel() {
  std::vector<SpeedProfileRow> rows;
  for (int scene = 0; scene < 24; ++scene) {
    for (int frame = 0; frame < 20; ++frame) {
      const double speed = scene % 3 == 0 ? 0.0 : 4.0 + 0.3 * scene + 0.1 * (frame * scene % 3);
      rows.push_back({"scene-" + std::to_string(scene), frame, speed, {}});
    }
  }
  SpeedModelFitOptions options = loadStudyConfig(kSource + "/config").speed_model_fit;
  options.centers = 5;
  options.profiles = 6;
  options.standing_profiles = 2;
  return fitSpeedModelWithFolds(SpeedSituations(rows), 2, options, 0);
}

class SpeedModelFile : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    path_ = (fs::path(testing::TempDir()) / (std::string("model_") + test->name())).string();
  }
  void TearDown() override { fs::remove_all(path_); }

  std::string content() const {
    std::stringstream text;
    text << std::ifstream(path_).rdbuf();
    return text.str();
  }

  /// Returns the error message of reading a text; "" if it succeeds.
  std::string complaintAbout(const std::string& text) const {
    std::ofstream(path_) << text;
    try {
      readSpeedModel(path_);
    } catch (const SpeedModelFileError& error) {
      return error.what();
    }
    return "";
  }

  /// Checks that the error message, after the first `from` is replaced, names the file and `parts`.
  void expectComplaint(const std::string& text, const std::string& from, const std::string& to,
                       const std::vector<std::string>& parts) const {
    const std::size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    const std::string said = complaintAbout(std::string(text).replace(at, from.size(), to));
    EXPECT_EQ(said.find(path_), 0u) << to << ": \"" << said << "\"";
    for (const std::string& part : parts) {
      EXPECT_NE(said.find(part), std::string::npos) << part << " in \"" << said << "\"";
    }
  }

  std::string path_;
};

TEST_F(SpeedModelFile, RoundTripsAModelToFiveDigits) {
  const SpeedModel written = smallModel();
  writeSpeedModel(written, path_);
  EXPECT_FALSE(fs::exists(path_ + ".part"));
  const SpeedModel read = readSpeedModel(path_);
  EXPECT_TRUE(read.weights().left_out_scenes.empty());
  ASSERT_EQ(read.folds().size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(read.folds()[i]->weights().left_out_scenes,
              written.folds()[i]->weights().left_out_scenes);
  }
  const auto same = [](const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
    return a.rows() == b.rows() && a.cols() == b.cols() &&
           ((a - b).array().abs() <= 5.1e-5 * b.array().abs()).all();
  };
  const SpeedModelWeights& a = read.folds()[1]->weights();
  const SpeedModelWeights& b = written.folds()[1]->weights();
  EXPECT_TRUE(same(a.feature_weights, b.feature_weights));
  EXPECT_TRUE(same(a.lowest, b.lowest));
  EXPECT_TRUE(same(a.highest, b.highest));
  EXPECT_TRUE(same(a.centers, b.centers));
  EXPECT_TRUE(same(a.gains, b.gains));
  EXPECT_TRUE(same(a.log_spreads, b.log_spreads));
  EXPECT_TRUE(same(a.residuals.profiles, b.residuals.profiles));
  EXPECT_TRUE(same(a.residuals.weights, b.residuals.weights));
  EXPECT_EQ(a.standing_speed, b.standing_speed);
  EXPECT_TRUE(same(a.standing, b.standing));
  EXPECT_TRUE(same(a.standing_shares, b.standing_shares));
  EXPECT_GT(a.standing.rows(), 0);
}

TEST_F(SpeedModelFile, RoundTripsAFile) {
  writeSpeedModel(smallModel(), path_);
  const std::string first = content();
  writeSpeedModel(readSpeedModel(path_), path_);
  EXPECT_EQ(content(), first);
}

TEST_F(SpeedModelFile, MalformedFilesAreNamed) {
  try {
    readSpeedModel(path_);
    FAIL();
  } catch (const SpeedModelFileError& error) {
    EXPECT_EQ(std::string(error.what()).find(path_ + ": cannot be opened"), 0u) << error.what();
  }
  writeSpeedModel(smallModel(), path_);
  const std::string good = content();
  const std::size_t second = good.find('\n') + 1;
  EXPECT_EQ(complaintAbout(good), "");
  EXPECT_NE(complaintAbout("").find("has no model"), std::string::npos);
  EXPECT_NE(complaintAbout(good.substr(0, second + 50)).find("line 2: invalid JSON"),
            std::string::npos);
  expectComplaint(good, "speed model 1", "speed model 9", {"line 1", "field format", "model 9"});
  expectComplaint(good, "\"centers\"", "\"middles\"", {"line 1", "field centers is missing"});
  expectComplaint(good, "\"format\"", "\"stray\":7,\"format\"", {"line 1", "field stray = 7"});
  expectComplaint(good, "\"standing_speed\":0.1", "\"standing_speed\":\"slow\"",
                  {"line 1", "standing_speed = \"slow\"", "not a number"});
  expectComplaint(good, "\"lowest\":[", "\"lowest\":[\"x\",", {"line 1", "field lowest", "\"x\""});
  expectComplaint(good, "\"lowest\":[", "\"lowest\":[1,",
                  {"line 1", "lowest is 1 x 11, not 1 x 10"});
  expectComplaint(good, "\"rows\":5,", "\"rows\":6,",
                  {"line 1", "field centers.values", "50 numbers", "6 x 10"});
  expectComplaint(good, "\"rows\":5,\"columns\":10", "\"rows\":10,\"columns\":5",
                  {"line 1", "centers is 10 x 5, not 10 x 10"});
  expectComplaint(good, "\"rows\":5,\"columns\":10", "\"rows\":0,\"columns\":0",
                  {"line 1", "field centers.values", "50 numbers", "0 x 0"});
  EXPECT_NE(complaintAbout(good + good.substr(second)).find("left_out_scenes has scene-"),
            std::string::npos);
}

}  // namespace
}  // namespace forge
