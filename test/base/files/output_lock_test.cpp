#include "collision_forge/base/files/output_lock.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>
#include <stdexcept>

#include "base/files/file_size_limit.h"
#include "io/logs/nuscenes_fixture.h"

namespace forge {
namespace {

namespace fs = std::filesystem;

std::string complaintOf(const std::function<OutputLock()>& lock) {
  try {
    lock();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

class OutputLockTest : public testing::Test {
 protected:
  std::string complaintOfFolder() const {
    return complaintOf([&] { return OutputLock::ofFolder(out_); });
  }

  TemporaryFolder folder_;
  const std::string out_ = folder_.path() + "/out";
  const std::string file_ = folder_.path() + "/out.bag";
};

TEST_F(OutputLockTest, NamesTheProcessThatHoldsIt) {
  const std::string held =
      ": is being written by process " + std::to_string(static_cast<long>(::getpid()));
  const OutputLock folder = OutputLock::ofFolder(out_);
  EXPECT_EQ(complaintOfFolder(), out_ + held);
  const OutputLock file = OutputLock::ofFile(file_);
  EXPECT_EQ(complaintOf([&] { return OutputLock::ofFile(file_); }), file_ + held);
}

TEST_F(OutputLockTest, NamesAFolderThatCannotBeCreated) {
  std::ofstream(out_) << "a file";
  const auto lock = [&] { return OutputLock::ofFolder(out_ + "/in"); };
  EXPECT_EQ(complaintOf(lock), out_ + "/in: cannot be created: Not a directory");
}

TEST_F(OutputLockTest, RemovesItsFiles) {
  { const OutputLock lock = OutputLock::ofFolder(out_); }
  EXPECT_FALSE(fs::exists(out_)) << "nothing was written to it";
  fs::create_directory(out_);
  { const OutputLock lock = OutputLock::ofFolder(out_); }
  EXPECT_TRUE(fs::is_empty(out_)) << "it was there before";
  { const OutputLock lock = OutputLock::ofFile(file_); }
  EXPECT_FALSE(fs::exists(file_ + ".lock"));
  EXPECT_EQ(complaintOfFolder(), "");
}

TEST_F(OutputLockTest, TakesOverTheLockOfAKilledProcess) {
  const pid_t child = ::fork();
  if (child == 0) {
    const OutputLock lock = OutputLock::ofFolder(out_);
    ::raise(SIGKILL);
  }
  ::waitpid(child, nullptr, 0);
  ASSERT_TRUE(fs::exists(out_ + "/.lock"));
  EXPECT_EQ(complaintOfFolder(), "");
}

TEST_F(OutputLockTest, KeepsAnotherFileOfThatName) {
  const std::string mine = folder_.write("out.bag.lock", "yarn.lock 1");
  EXPECT_EQ(complaintOf([&] { return OutputLock::ofFile(file_); }),
            file_ + ": cannot be written: " + mine +
                ": is not a lock file of this program; delete it, or choose another output");
  std::ifstream file(mine);
  std::string text;
  std::getline(file, text);
  EXPECT_EQ(text, "yarn.lock 1");
}

TEST_F(OutputLockTest, OnlyOneProcessHoldsIt) {
  constexpr int kProcesses = 8;
  constexpr int kTimes = 500;
  const std::string alone = folder_.path() + "/alone";  // exists while a process holds the lock
  std::vector<pid_t> children;
  for (int process = 0; process < kProcesses; ++process) {
    children.push_back(::fork());
    if (children.back() != 0) continue;
    bool is_alone = true;
    for (int i = 0; i < kTimes; ++i) {
      try {
        const OutputLock lock = OutputLock::ofFile(file_);
        is_alone &= fs::create_directory(alone);
        fs::remove(alone);
      } catch (const std::runtime_error&) {
        continue;  // another process holds it
      }
    }
    ::_exit(is_alone ? 0 : 1);
  }
  for (const pid_t child : children) {
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_EQ(status, 0);
  }
  EXPECT_FALSE(fs::exists(file_ + ".lock"));
}

TEST_F(OutputLockTest, DoesNotFollowLinks) {
  const std::string other = folder_.path() + "/other";
  std::ofstream(other) << "of somebody else";
  fs::create_symlink(other, file_ + ".lock");
  EXPECT_EQ(complaintOf([&] { return OutputLock::ofFile(file_); }),
            file_ + ": cannot be written: " + file_ + ".lock: Too many levels of symbolic links");
  EXPECT_EQ(fs::file_size(other), 16u);
}

}  // namespace
}  // namespace forge
