#include "collision_forge/app/export_mcap.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "collision_forge/app/command_line.h"
#include "collision_forge/planner_test/settings/config.h"
#include "collision_forge/ros/bags/bag_file.h"
#include "std_msgs/Float64.h"

namespace forge {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class ExportMcapTest : public testing::Test {
 protected:
  ExportMcapTest() {
    fs::create_directories(folder_ / "bags");
    for (const char* name : {"a", "b"}) {
      NewBag bag(bagOf(name));
      bag.write("/number", ros::Time(1.0), std_msgs::Float64());
      bag.commit();
    }
  }
  ~ExportMcapTest() override { fs::remove_all(folder_); }

  std::string bagOf(const std::string& name) const { return folder_ / "bags" / (name + ".bag"); }
  fs::path made(const std::string& name) const { return fs::path(out_) / name; }
  static std::string bytesOf(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  }

  /// Returns the exit code and the output.
  std::string run(const std::vector<std::string>& bags) const {
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    const int code = exportMcap(bags, out_, config_);
    const std::string printed = testing::internal::GetCapturedStdout();
    return std::to_string(code) + ": " + printed + testing::internal::GetCapturedStderr();
  }

  const fs::path folder_ =
      fs::temp_directory_path() / ("collision_forge_export_mcap_" + std::to_string(getpid()));
  const std::string out_ = folder_ / "out";
  const Config config_ = loadConfig(std::string(COLLISION_FORGE_SOURCE_DIR) + "/config");
};

TEST_F(ExportMcapTest, WritesAFileForEachBagAndALayout) {
  EXPECT_THAT(run({bagOf("a"), bagOf("b")}), testing::StartsWith("0: 2 of 2 bags exported"));
  EXPECT_TRUE(fs::exists(made("a.mcap")));
  EXPECT_TRUE(fs::exists(made("b.mcap")));
  EXPECT_TRUE(fs::exists(made("layout.json")));
}

TEST_F(ExportMcapTest, SkipsExistingFiles) {
  fs::create_directories(out_);
  for (const char* name : {"a.mcap", "layout.json"}) std::ofstream(made(name)) << "mine";
  EXPECT_THAT(run({bagOf("a"), bagOf("b")}),
              HasSubstr("1 of 2 bags exported to " + out_ + ", 1 exported before"));
  EXPECT_EQ(bytesOf(made("a.mcap")), "mine");
  EXPECT_EQ(bytesOf(made("layout.json")), "mine");
  EXPECT_TRUE(fs::exists(made("b.mcap")));
}

TEST_F(ExportMcapTest, ReportsFailedBagsAndContinues) {
  const std::string missing = bagOf("missing");
  const std::string printed = run({missing, bagOf("b")});
  EXPECT_THAT(printed, testing::StartsWith(std::to_string(kExitError)));
  EXPECT_THAT(printed, HasSubstr("not exported: " + missing));
  EXPECT_TRUE(fs::exists(made("b.mcap")));
}

TEST_F(ExportMcapTest, RejectsTwoBagsOfTheSameName) {
  fs::create_directories(folder_ / "others");
  const std::string other = folder_ / "others" / "a.bag";
  fs::copy(bagOf("a"), other);
  EXPECT_THROW(exportMcap({bagOf("a"), other}, out_, config_), std::invalid_argument);
  EXPECT_FALSE(fs::exists(out_));
}

}  // namespace
}  // namespace forge
