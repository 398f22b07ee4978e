#include "collision_forge/base/files/file_fingerprint.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <stdexcept>

#include "io/logs/nuscenes_fixture.h"

namespace forge {
namespace {

namespace fs = std::filesystem;

class FileFingerprintTest : public testing::Test {
 protected:
  void SetUp() override {
    folder_.write("tree/a.json", "[1]");
    folder_.write("tree/deep/b.json", "[2]");
    folder_.write("tree/c.txt", "text");
  }

  const TemporaryFolder folder_;
  const std::string tree_ = folder_.path() + "/tree";
};

TEST_F(FileFingerprintTest, ChangesWithContentsNamesAndNumber) {
  const std::string before = fingerprintOfTree(tree_);
  EXPECT_THAT(before, testing::StartsWith("3 files, fingerprint "));
  EXPECT_EQ(fingerprintOfTree(tree_), before);
  std::set<std::string> known = {before};
  folder_.write("tree/deep/b.json", "[3]");
  EXPECT_TRUE(known.insert(fingerprintOfTree(tree_)).second) << "another content";
  fs::rename(tree_ + "/deep/b.json", tree_ + "/deep/d.json");
  EXPECT_TRUE(known.insert(fingerprintOfTree(tree_)).second) << "another name";
  folder_.write("tree/empty.json", "");
  EXPECT_TRUE(known.insert(fingerprintOfTree(tree_)).second) << "one more";
  folder_.write("tree/a.json", "[1]t");
  folder_.write("tree/c.txt", "ext");
  EXPECT_TRUE(known.insert(fingerprintOfTree(tree_)).second) << "a byte in the next file";
}

TEST_F(FileFingerprintTest, DependsOnContentsNotOnTimesAndPlaces) {
  const std::string before = fingerprintOfTree(tree_);
  fs::last_write_time(tree_ + "/a.json", {});
  EXPECT_EQ(fingerprintOfTree(tree_), before);
  fs::rename(tree_, folder_.path() + "/moved");
  fs::create_directory_symlink(folder_.path() + "/moved", tree_);
  EXPECT_EQ(fingerprintOfTree(tree_), before);
}

TEST_F(FileFingerprintTest, OfALargeFileCoversSizeTimeAndEnds) {
  const std::string path = folder_.path() + "/large";
  const std::uintmax_t size = (std::uintmax_t{64} << 20U) + 1;
  std::ofstream(path) << "begin";
  fs::resize_file(path, size);
  const auto time = fs::last_write_time(path);
  std::set<std::string> known = {fingerprintOfFiles({path})};
  const auto write = [&](std::uintmax_t at) {
    std::fstream file(path, std::ios::in | std::ios::out);
    file.seekp(static_cast<std::streamoff>(at));
    file << 'x';
    file.close();
    fs::last_write_time(path, time);
  };
  write(0);
  EXPECT_TRUE(known.insert(fingerprintOfFiles({path})).second);
  write(size - 1);
  EXPECT_TRUE(known.insert(fingerprintOfFiles({path})).second);
  write(size / 2);
  EXPECT_FALSE(known.insert(fingerprintOfFiles({path})).second) << "its middle is not read";
  fs::last_write_time(path, time + std::chrono::nanoseconds(1));
  EXPECT_TRUE(known.insert(fingerprintOfFiles({path})).second);
}

TEST_F(FileFingerprintTest, NamesAFileThatCannotBeRead) {
  try {
    fingerprintOfTree(folder_.path() + "/none");
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(error.what(), folder_.path() + "/none: cannot be read: No such file or directory");
  }
}

}  // namespace
}  // namespace forge
