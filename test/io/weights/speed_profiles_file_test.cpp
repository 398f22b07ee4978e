#include "collision_forge/io/weights/speed_profiles_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

namespace forge {
namespace {

namespace fs = std::filesystem;

const char* const kHeader =
    "scene,frame,speed,turn_rate,bend_braking,bend_turn,bend_curvature,headway,closing\n";

class SpeedProfilesFile : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    path_ = (fs::path(testing::TempDir()) / (std::string("profiles_") + test->name())).string();
  }
  void TearDown() override { fs::remove_all(path_); }

  void write(const std::string& text) const { std::ofstream(path_) << text; }

  std::string content() const {
    std::stringstream text;
    text << std::ifstream(path_).rdbuf();
    return text.str();
  }

  /// What reading says; empty when it succeeds.
  std::string complaint() const {
    try {
      readSpeedSituations(path_);
    } catch (const SpeedProfilesFileError& error) {
      return error.what();
    }
    return "";
  }

  void expectComplaint(const std::string& text, const std::vector<std::string>& parts) const {
    write(text);
    const std::string said = complaint();
    EXPECT_NE(said.find(path_), std::string::npos) << text << ": \"" << said << "\"";
    for (const std::string& part : parts) {
      EXPECT_NE(said.find(part), std::string::npos) << part << " in \"" << said << "\"";
    }
  }

  std::string path_;
};

TEST_F(SpeedProfilesFile, WhatIsWrittenIsReadToTheThirdDecimal) {
  const std::vector<SpeedProfileRow> rows = {
      {"scene-1", 1, 8.12345, {0.0123, -1.5, 0.25, 0.0125, 1.75, -0.5}},
      {"scene-1", 2, -0.0001, {0, 0, 0, 0, 0, 0}},
      {"scene-2", 1, 3.0, {1, 2, 3, 4, 5, 6}}};
  writeSpeedProfiles(rows, path_);
  EXPECT_FALSE(fs::exists(path_ + ".part"));
  EXPECT_EQ(content(), std::string(kHeader) +
                           "scene-1,1,8.123,0.012,-1.5,0.25,0.013,1.75,-0.5\n"
                           "scene-1,2,0,0,0,0,0,0,0\n"
                           "scene-2,1,3,1,2,3,4,5,6\n");
  const auto read = readSpeedSituations(path_).rows();
  ASSERT_EQ(read.size(), 3u);
  EXPECT_EQ(read[0].scene, "scene-1");
  EXPECT_EQ(read[1].frame, 2);
  EXPECT_EQ(read[0].speed, 8.123);
  EXPECT_EQ(read[0].ahead.turn_rate, 0.012);
  EXPECT_EQ(read[0].ahead.bend_braking, -1.5);
  EXPECT_EQ(read[0].ahead.bend_turn, 0.25);
  EXPECT_EQ(read[0].ahead.bend_curvature, 0.013);
  EXPECT_EQ(read[0].ahead.headway, 1.75);
  EXPECT_EQ(read[0].ahead.closing, -0.5);
}

TEST_F(SpeedProfilesFile, MalformedLinesAreNamed) {
  const std::string header = kHeader;
  EXPECT_NE(complaint().find(path_), std::string::npos) << "no file";
  expectComplaint("", {"cannot be read"});
  expectComplaint("scene,frame\n", {"line 1", "scene,frame"});
  expectComplaint(header + "a,1,2,0,0,0,0,0,0\na,2,2,0,0,0,0,0\n", {"line 3", "8 values"});
  expectComplaint(header + "a,1,fast,0,0,0,0,0,0\n", {"line 2", "speed", "fast"});
  expectComplaint(header + "a,1,2 ,0,0,0,0,0,0\n", {"line 2", "speed", "\"2 \""});
  expectComplaint(header + "a,1,nan,0,0,0,0,0,0\n", {"line 2", "speed", "nan"});
  expectComplaint(header + "a,1,1e300,0,0,0,0,0,0\n", {"line 2", "speed", "1e300", "beyond"});
  expectComplaint(header + "a,1,2,0,0,0,0,0,-151\n", {"line 2", "closing", "-151", "beyond"});
  expectComplaint(header + "a,1.5,2,0,0,0,0,0,0\n", {"line 2", "frame", "1.5"});
  expectComplaint(header + "a,1,2,0,0,0,0,0,\n", {"line 2", "closing", "\"\""});
  expectComplaint(header + ",1,2,0,0,0,0,0,0\n", {"line 2", "scene"});
  expectComplaint(header + "a,2,2,0,0,0,0,0,0\na,1,2,0,0,0,0,0,0\n", {"a, frame 1", "order"});
}

}  // namespace
}  // namespace forge
