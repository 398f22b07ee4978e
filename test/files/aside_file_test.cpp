#include "collision_forge/files/aside_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <map>
#include <sstream>
#include <stdexcept>

namespace forge {
namespace {

namespace fs = std::filesystem;

std::string contentOf(const std::string& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

std::string complaintOf(const std::function<void()>& action) {
  try {
    action();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

class AsideFileTest : public testing::Test {
 protected:
  void SetUp() override {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  const std::string folder_ = testing::TempDir() + "aside_file_test";
  const std::string path_ = folder_ + "/file";
  const std::string part_ = path_ + ".part";
};

TEST_F(AsideFileTest, TakesItsPlaceWhenComplete) {
  writeText(path_, "before");
  AsideFile file(path_);
  file.stream() << "one" << std::string(1, '\0') << "\r\n";
  file.stream() << "two";
  EXPECT_EQ(contentOf(path_), "before");
  file.commit();
  EXPECT_EQ(contentOf(path_), std::string("one\0\r\ntwo", 9));
  EXPECT_FALSE(fs::exists(part_));
}

TEST_F(AsideFileTest, WithoutCommitAllIsAsBefore) {
  writeText(path_, "before");
  { AsideFile(path_).stream() << "after"; }
  EXPECT_EQ(contentOf(path_), "before");
  EXPECT_FALSE(fs::exists(part_));
}

TEST_F(AsideFileTest, MovesWhatOthersWroteByName) {
  AsideFile file(path_);
  std::ofstream(file.partPath()) << "by name";
  file.commit();
  EXPECT_EQ(contentOf(path_), "by name");
}

TEST_F(AsideFileTest, SaysWhyItCannotBeMade) {
  AsideFile file(folder_ + "/none/file");
  EXPECT_EQ(complaintOf([&] { file.stream(); }),
            folder_ + "/none/file: cannot be written: No such file or directory");
}

TEST_F(AsideFileTest, AFullDiskLosesNothing) {
  writeText(path_, "before");
  const std::map<std::size_t, std::string> complaints = {
      {1, ": cannot be written: No space left on device"},
      {std::size_t{1} << 20U, ": cannot be written to its end; is the disk full?"}};
  for (const auto& [size, complaint] : complaints) {
    fs::create_symlink("/dev/full", part_);
    EXPECT_EQ(complaintOf([&] { writeText(path_, std::string(size, 'x')); }), path_ + complaint);
    EXPECT_EQ(contentOf(path_), "before");
    EXPECT_FALSE(fs::exists(fs::symlink_status(part_)));
  }
}

TEST_F(AsideFileTest, ReplacesFilesAlone) {
  EXPECT_EQ(complaintOf([] { AsideFile("/dev/null"); }), "/dev/null: is there and no file");
  EXPECT_EQ(complaintOf([&] { writeText(folder_, "text"); }), folder_ + ": is there and no file");
  EXPECT_TRUE(fs::is_directory(folder_));
}

}  // namespace
}  // namespace forge
