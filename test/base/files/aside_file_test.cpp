#include "collision_forge/base/files/aside_file.h"

#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>

#include "base/files/file_size_limit.h"
#include "base/files/left_part.h"

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

std::set<std::string> namesIn(const std::string& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) {
    names.insert(entry.path().filename().string());
  }
  return names;
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

TEST_F(AsideFileTest, ReplacesTheFileWhenComplete) {
  writeText(path_, "before");
  AsideFile file(path_);
  file.stream() << "one" << std::string(1, '\0') << "\r\n";
  file.stream() << "two";
  EXPECT_EQ(contentOf(path_), "before");
  file.commit();
  EXPECT_EQ(contentOf(path_), std::string("one\0\r\ntwo", 9));
  EXPECT_FALSE(fs::exists(part_));
}

TEST_F(AsideFileTest, RefusesToReplaceAnUnfinishedRun) {
  leavePart(path_, "item\n");
  EXPECT_THAT(complaintOf([&] { writeText(path_, "other"); }),
              testing::HasSubstr(path_ + ": an unfinished run is in " + part_));
  EXPECT_EQ(contentOf(part_), "item\n");
  EXPECT_FALSE(fs::exists(path_));
}

TEST_F(AsideFileTest, ReportsWhyItCannotBeCreated) {
  EXPECT_EQ(complaintOf([&] { AsideFile(folder_ + "/none/file"); }),
            folder_ + "/none/file: cannot be written: No such file or directory");
}

TEST_F(AsideFileTest, AFullDiskLosesNothing) {
  writeText(path_, "before");
  const std::map<std::size_t, std::string> complaints = {
      {9, ": cannot be written: File too large"},
      {std::size_t{1} << 20U, ": could not be written completely; is the disk full?"}};
  for (const auto& [size, complaint] : complaints) {
    const FileSizeLimit limit(8);  // bytes
    EXPECT_EQ(complaintOf([&, size = size] { writeText(path_, std::string(size, 'x')); }),
              path_ + complaint);
    EXPECT_EQ(contentOf(path_), "before");
    EXPECT_FALSE(fs::exists(part_));
  }
}

TEST_F(AsideFileTest, ConcurrentWritersUseSeparateParts) {
  AsideFile first(path_);
  AsideFile second(path_);
  EXPECT_NE(first.partPath(), second.partPath());
  first.stream() << "the first";
  second.stream() << "the second";
  second.commit();
  EXPECT_EQ(contentOf(path_), "the second");
  first.commit();
  EXPECT_EQ(contentOf(path_), "the first");
  EXPECT_EQ(namesIn(folder_), std::set<std::string>{"file"});
}

TEST_F(AsideFileTest, ConcurrentProcessesLeaveACompleteFile) {
  constexpr int kProcesses = 8;
  constexpr int kFiles = 50;
  const std::size_t size = 100000;
  std::vector<pid_t> children;
  for (int process = 0; process < kProcesses; ++process) {
    children.push_back(::fork());
    if (children.back() != 0) continue;
    bool is_whole = true;
    try {
      for (int i = 0; i < kFiles; ++i) {
        writeText(path_, std::string(size, static_cast<char>('a' + process)));
        const std::string content = contentOf(path_);
        is_whole &= content == std::string(size, content.front());
      }
    } catch (const std::exception& error) {
      std::fprintf(stderr, "%s\n", error.what());
      is_whole = false;
    }
    ::_exit(is_whole ? 0 : 1);
  }
  for (const pid_t child : children) {
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_EQ(status, 0);
  }
  EXPECT_EQ(namesIn(folder_), std::set<std::string>{"file"});
}

TEST_F(AsideFileTest, RemovesThePartOfAKilledProcess) {
  const pid_t child = ::fork();
  if (child == 0) {
    AsideFile file(path_);
    file.stream() << "half" << std::flush;
    ::raise(SIGKILL);
  }
  ::waitpid(child, nullptr, 0);
  ASSERT_EQ(contentOf(part_), "half");
  writeText(path_, "whole");
  EXPECT_EQ(contentOf(path_), "whole");
  EXPECT_EQ(namesIn(folder_), std::set<std::string>{"file"});
}

TEST_F(AsideFileTest, DoesNotFollowPlantedLinks) {
  const std::string other = folder_ + "/other";
  std::ofstream(other) << "of somebody else";
  for (const auto& target : {other, folder_ + "/not_there"}) {
    fs::create_symlink(target, part_);
    writeText(path_, "text");
    EXPECT_EQ(contentOf(path_), "text");
    fs::remove(part_);
  }
  fs::create_hard_link(other, part_);
  writeText(path_, "text");
  EXPECT_EQ(contentOf(other), "of somebody else");
  EXPECT_EQ(namesIn(folder_), (std::set<std::string>{"file", "other"}));
}

TEST_F(AsideFileTest, ReplacesOnlyFiles) {
  EXPECT_EQ(complaintOf([] { AsideFile("/dev/null"); }), "/dev/null: exists and is not a file");
  EXPECT_EQ(complaintOf([&] { writeText(folder_, "text"); }),
            folder_ + ": exists and is not a file");
  EXPECT_TRUE(fs::is_directory(folder_));
}

}  // namespace
}  // namespace forge
