#include "collision_forge/app/export_mcap.h"

#include <collision_forge/AgentArray.h>
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
  std::string run(const std::vector<std::string>& bags, BagExport format = BagExport::kMcap) const {
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    const int code = exportBags(bags, out_, format, config_);
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

TEST_F(ExportMcapTest, RejectsExistingFilesOfTheOtherProfileAndContinues) {
  run({bagOf("a")}, BagExport::kMcap);
  const std::string before = bytesOf(made("a.mcap"));
  EXPECT_THAT(run({bagOf("a"), bagOf("b")}, BagExport::kRos2Mcap),
              testing::AllOf(testing::StartsWith(std::to_string(kExitError)),
                             HasSubstr("a.mcap exists with profile ros1, not ros2"),
                             HasSubstr("1 of 2 bags exported")));
  EXPECT_EQ(bytesOf(made("a.mcap")), before);
  EXPECT_THAT(run({bagOf("b")}, BagExport::kMcap),
              HasSubstr("b.mcap exists with profile ros2, not ros1"));
}

TEST_F(ExportMcapTest, ReportsFailedBagsAndContinues) {
  const std::string missing = bagOf("missing");
  const std::string printed = run({missing, bagOf("b")});
  EXPECT_THAT(printed, testing::StartsWith(std::to_string(kExitError)));
  EXPECT_THAT(printed, HasSubstr("not exported: " + missing));
  EXPECT_TRUE(fs::exists(made("b.mcap")));
}

TEST_F(ExportMcapTest, WritesARosbag2FolderForEachBag) {
  EXPECT_THAT(run({bagOf("a"), bagOf("missing")}, BagExport::kRosbag2),
              testing::StartsWith(std::to_string(kExitError) + ": 1 of 2 bags exported"));
  EXPECT_TRUE(fs::exists(made("a/a.mcap")));
  EXPECT_FALSE(fs::exists(made("missing")));
  const std::string metadata = bytesOf(made("a/metadata.yaml"));
  EXPECT_THAT(metadata, HasSubstr(R"("relative_file_paths":["a.mcap"])"));
  EXPECT_THAT(metadata, HasSubstr(R"("name":"/number","type":"std_msgs/msg/Float64")"));
  EXPECT_THAT(metadata, HasSubstr(R"("message_count":1)"));
  EXPECT_THAT(run({bagOf("a")}, BagExport::kRosbag2), HasSubstr("1 exported before"));
}

TEST_F(ExportMcapTest, WritesThePackageOfOwnMessagesAndRejectsOtherDefinitions) {
  {
    NewBag bag(bagOf("own"));
    bag.write("/agents", ros::Time(1.0), collision_forge::AgentArray());
    bag.commit();
  }
  EXPECT_THAT(run({bagOf("own")}, BagExport::kRos2Mcap), testing::StartsWith("0: 1 of 1 bag"));
  const fs::path message = made("collision_forge_msgs/msg/AgentArray.msg");
  EXPECT_THAT(bytesOf(message), HasSubstr("\nAgent[] agents\n"));
  EXPECT_THAT(bytesOf(made("collision_forge_msgs/package.xml")),
              testing::AllOf(HasSubstr("<depend>geometry_msgs</depend>"),
                             HasSubstr("<depend>std_msgs</depend>")));
  EXPECT_THAT(bytesOf(made("collision_forge_msgs/CMakeLists.txt")),
              HasSubstr("DEPENDENCIES geometry_msgs std_msgs)"));
  fs::remove(made("own.mcap"));
  std::ofstream(message, std::ios::app) << "int8 other\n";
  EXPECT_THAT(run({bagOf("own")}, BagExport::kRos2Mcap),
              HasSubstr("AgentArray.msg: has another definition than the bag's /agents"));
  EXPECT_FALSE(fs::exists(made("own.mcap")));
}

TEST_F(ExportMcapTest, RejectsTwoBagsOfTheSameName) {
  fs::create_directories(folder_ / "others");
  const std::string other = folder_ / "others" / "a.bag";
  fs::copy(bagOf("a"), other);
  EXPECT_THROW(exportBags({bagOf("a"), other}, out_, BagExport::kMcap, config_),
               std::invalid_argument);
  EXPECT_FALSE(fs::exists(out_));
}

}  // namespace
}  // namespace forge
