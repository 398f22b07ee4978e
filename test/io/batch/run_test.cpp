#include "collision_forge/io/batch/run.h"

#include <gmock/gmock.h>
#include <signal.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "base/files/left_part.h"
#include "io/logs/nuscenes_fixture.h"

namespace forge {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;

constexpr std::size_t kCount = 40;

std::string contentOf(const std::string& path) {
  std::ostringstream content;
  content << std::ifstream(path).rdbuf();
  return content.str();
}

/// Squares of the first numbers, two lines per item.
class RunTest : public testing::Test {
 protected:
  forge::Run squares() {
    taken_.clear();
    forge::Run run;
    run.path = path_;
    run.options = {{"power", "2"}};
    run.layout = {"number and square", 2};
    run.items = "numbers";
    run.count = kCount;
    run.jobs = 2;
    run.work = [](std::size_t index) {
      return std::to_string(index) + "\n" + std::to_string(index * index);
    };
    run.take = [this](std::size_t index, const std::string& where, const std::string& lines) {
      if (lines.substr(0, lines.find('\n')) != std::to_string(index)) {
        throw std::runtime_error(where + ": is not of " + std::to_string(index));
      }
      EXPECT_EQ(taken_.size(), index) << "in order";
      taken_.push_back(lines);
    };
    return run;
  }

  /// The whole file, or its first items.
  static std::string expected(std::size_t count = kCount) {
    std::string text = "number and square\n";
    for (std::size_t i = 0; i < count; ++i) {
      text += std::to_string(i) + "\n" + std::to_string(i * i) + "\n";
    }
    return text;
  }

  /// Creates the files of an interrupted run.
  void leave(const std::string& path, const std::string& text) const {
    std::ofstream(path) << text;
    leaveOptions();
  }
  void leavePartOf(const std::string& text) const {
    leavePart(path_, text, {"number and square", 2});
    leaveOptions();
  }
  void leaveOptions(const std::string& program = "collision_forge " COLLISION_FORGE_VERSION) const {
    std::ofstream(path_ + ".options") << "power: 2\nprogram: " << program << "\n";
  }

  /// Returns the error message of carryOut(); "" if there is none.
  std::string complaintOf(const forge::Run& run) {
    try {
      carryOut(run);
    } catch (const std::exception& error) {
      return error.what();
    }
    return "";
  }

  void expectComplaint(const forge::Run& run, const std::string& text) {
    EXPECT_THAT(complaintOf(run), HasSubstr(text));
  }

  TemporaryFolder folder_;
  const std::string path_ = folder_.path() + "/squares";
  const std::string part_ = path_ + ".part";
  std::vector<std::string> taken_;
};

TEST_F(RunTest, TakesAndWritesResultsInOrder) {
  carryOut(squares());
  EXPECT_EQ(taken_.size(), kCount);
  EXPECT_EQ(contentOf(path_), expected());
}

TEST_F(RunTest, ResumesAfterTheLastCompleteItem) {
  leavePartOf(expected(7) + "7\n");  // killed within an item
  forge::Run run = squares();
  const auto work = run.work;
  run.work = [&](std::size_t index) {
    EXPECT_GE(index, 7u) << "done before";
    return work(index);
  };
  carryOut(run);
  EXPECT_EQ(taken_.size(), kCount) << "with those of the run before";
  EXPECT_EQ(contentOf(path_), expected());
  EXPECT_FALSE(fs::exists(part_));
}

TEST_F(RunTest, ReadsACompleteFileAndKeepsIt) {
  leave(path_, expected());
  forge::Run run = squares();
  run.work = [](std::size_t) -> std::string { throw std::logic_error("nothing is to be done"); };
  carryOut(run);
  EXPECT_EQ(taken_.size(), kCount);
  EXPECT_FALSE(fs::exists(part_));
}

TEST_F(RunTest, RejectsOtherOptionsAndKeepsTheFile) {
  leavePartOf(expected(7));
  forge::Run run = squares();
  run.options = {{"power", "3"}};
  expectComplaint(run, "power = 2, not 3");
  run.options = {};
  expectComplaint(run, "power = 2");
  EXPECT_EQ(contentOf(part_), expected(7));
}

TEST_F(RunTest, RejectsForeignItemsByLine) {
  leavePartOf(expected(2) + "3\n9\n");
  expectComplaint(squares(), part_ + ": line 6: is not of 2");
  leavePartOf("another header\n");
  expectComplaint(squares(), part_ + ": line 1");
  leavePartOf(expected(kCount + 1));
  expectComplaint(squares(), "there are only 40 numbers");
}

TEST_F(RunTest, AnErrorKeepsTheItemsBeforeIt) {
  forge::Run run = squares();
  const auto work = run.work;
  run.work = [&](std::size_t index) {
    if (index == 11) throw std::runtime_error("no square of 11");
    return work(index);
  };
  expectComplaint(run, "no square of 11");
  EXPECT_EQ(contentOf(part_), expected(11));
}

}  // namespace
}  // namespace forge
