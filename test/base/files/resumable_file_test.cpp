#include "collision_forge/base/files/resumable_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "base/files/file_size_limit.h"
#include "base/files/left_part.h"
#include "collision_forge/base/files/aside_file.h"
#include "io/logs/nuscenes_fixture.h"

namespace forge {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

const ResumableFile::Options kOptions = {{"mode", "history"}, {"version", "v1.0-mini"}};

std::string contentOf(const std::string& path) {
  std::ostringstream content;
  content << std::ifstream(path).rdbuf();
  return content.str();
}

class ResumableFileTest : public testing::Test {
 protected:
  std::vector<std::string> resumed(ResumableFile& file) const {
    std::vector<std::string> lines;
    const std::size_t count =
        file.resume([&](const std::string&, const std::string& line) { lines.push_back(line); });
    EXPECT_EQ(count, lines.size());
    return lines;
  }

  std::string complaint(const ResumableFile::Options& options = kOptions) const {
    try {
      ResumableFile file(path_, options);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  }

  TemporaryFolder folder_;
  const std::string path_ = folder_.path() + "/lines";
  const std::string part_ = path_ + ".part";
};

TEST_F(ResumableFileTest, HasItsNameOnlyWhenComplete) {
  ResumableFile file(path_, kOptions);
  EXPECT_FALSE(file.isComplete());
  EXPECT_TRUE(resumed(file).empty());
  file.append("one");
  EXPECT_FALSE(fs::exists(path_));
  EXPECT_EQ(contentOf(part_), "one\n") << "written at once";
  file.append("two");
  file.complete();
  EXPECT_EQ(contentOf(path_), "one\ntwo\n");
  EXPECT_FALSE(fs::exists(part_));
  EXPECT_TRUE(fs::exists(path_ + ".options"));
}

TEST_F(ResumableFileTest, ResumesAfterTheLastCompleteLine) {
  {
    ResumableFile file(path_, kOptions);
    resumed(file);
    file.append("one");
    file.append("two");
  }
  std::ofstream(part_, std::ios::app) << "thr";  // killed while writing
  ResumableFile file(path_, kOptions);
  std::vector<std::string> places;
  file.resume([&](const std::string& where, const std::string& line) {
    places.push_back(where + " " + line);
  });
  EXPECT_THAT(places, ElementsAre(part_ + ": line 1 one", part_ + ": line 2 two"));
  file.append("three");
  file.complete();
  EXPECT_EQ(contentOf(path_), "one\ntwo\nthree\n");
}

TEST_F(ResumableFileTest, RejectsAnAlteredLineThatCanBeRepeated) {
  leavePart(path_, "one\ntwo\nthree\n");
  writeText(path_ + ".options", "mode: history\nversion: v1.0-mini\n");
  std::ofstream(part_) << "one\ntvo\nthree\n";
  std::vector<std::string> lines;
  try {
    ResumableFile(path_, kOptions).resume([&](const std::string&, const std::string& line) {
      lines.push_back(line);
    });
    FAIL() << "taken";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr(part_ + ": line 2: was altered"));
  }
  EXPECT_THAT(lines, ElementsAre("one"));
  EXPECT_EQ(contentOf(part_), "one\ntvo\nthree\n");
  std::ofstream(part_) << "one\n";  // the remedy in the message
  ResumableFile file(path_, kOptions);
  EXPECT_THAT(resumed(file), ElementsAre("one"));
  file.append("two");
  file.complete();
  EXPECT_EQ(contentOf(path_), "one\ntwo\n");
  EXPECT_FALSE(fs::exists(part_ + ".sums"));
}

TEST_F(ResumableFileTest, RejectsReorderedLines) {
  leavePart(path_, "one\ntwo\n");
  writeText(path_ + ".options", "mode: history\nversion: v1.0-mini\n");
  std::ofstream(part_) << "two\none\n";
  ResumableFile file(path_, kOptions);
  EXPECT_THROW(resumed(file), std::runtime_error);
}

TEST_F(ResumableFileTest, RepeatsItemsWithoutChecksum) {
  leavePart(path_, "one\ntwo\n");
  writeText(path_ + ".options", "mode: history\nversion: v1.0-mini\n");
  for (const std::uintmax_t left :
       {17 + 5, 17, 16, 0}) {  // killed during or before writing the checksum
    fs::resize_file(part_ + ".sums", left);
    ResumableFile file(path_, kOptions);
    EXPECT_EQ(resumed(file).size(), left / 17) << left;
    EXPECT_EQ(contentOf(part_), left < 17 ? "" : "one\n");
    EXPECT_EQ(fs::file_size(part_ + ".sums"), left / 17 * 17);
  }
}

TEST_F(ResumableFileTest, AnExceptionOfTheReaderKeepsTheFile) {
  {
    ResumableFile file(path_, kOptions);
    resumed(file);
    file.append("one");
  }
  std::ofstream(part_, std::ios::app) << "tw";
  {
    ResumableFile file(path_, kOptions);
    EXPECT_THROW(file.resume([](const std::string&, const std::string&) { throw 1; }), int);
  }
  EXPECT_EQ(contentOf(part_), "one\ntw");
}

TEST_F(ResumableFileTest, KeepsACompleteFile) {
  {
    ResumableFile file(path_, kOptions);
    resumed(file);
    file.append("one");
    file.complete();
  }
  const ResumableFile again(path_, kOptions);
  EXPECT_TRUE(again.isComplete());
  EXPECT_FALSE(fs::exists(part_));
  EXPECT_THAT(complaint({{"mode", "replay"}, {"version", "v1.0-mini"}}),
              AllOf(HasSubstr(path_ + ":"), HasSubstr("mode = history, not replay")));
}

TEST_F(ResumableFileTest, RejectsOtherOptionsOnceThereAreLines) {
  { const ResumableFile file(path_, kOptions); }
  EXPECT_EQ(complaint({{"mode", "replay"}}), "") << "nothing to lose yet";
  std::ofstream(part_) << "one\n";
  EXPECT_EQ(complaint({{"mode", "replay"}}), "");
  EXPECT_THAT(complaint({}), HasSubstr("mode = replay"));
  EXPECT_THAT(complaint(), AllOf(HasSubstr(part_), HasSubstr("mode = replay, not history")));
  EXPECT_EQ(contentOf(part_), "one\n");
}

TEST_F(ResumableFileTest, RejectsASecondWriter) {
  const ResumableFile file(path_, kOptions);
  EXPECT_THAT(complaint(), AllOf(HasSubstr(part_), HasSubstr("is being written")));
}

TEST_F(ResumableFileTest, KeepsEarlierLinesOnAFullDisk) {
  ResumableFile file(path_, kOptions);
  resumed(file);
  file.append("one");
  std::string complaint;
  try {
    const FileSizeLimit limit(8);  // bytes: "one\n" and half a line
    file.append("two, three");
  } catch (const std::runtime_error& error) {
    complaint = error.what();
  }
  EXPECT_THAT(complaint, AllOf(HasSubstr(part_), HasSubstr("File too large")));
  EXPECT_EQ(contentOf(part_), "one\n");
}

TEST_F(ResumableFileTest, CutsOffIncompleteItemsOfSeveralLines) {
  const ItemLayout layout = {"header", 2};
  {
    ResumableFile file(path_, kOptions, layout);
    resumed(file);
    EXPECT_EQ(contentOf(part_), "header\n");
    file.append("one\n1");
    file.append("two\n2");
  }
  const std::string whole = contentOf(part_);
  EXPECT_EQ(whole, "header\none\n1\ntwo\n2\n");
  for (std::size_t length = 0; length <= whole.size(); ++length) {
    leavePart(path_, whole.substr(0, length), layout);
    ResumableFile file(path_, kOptions, layout);
    const std::size_t items = resumed(file).size();
    EXPECT_EQ(items, length < 13 ? 0u : length < 19 ? 1u : 2u) << length;
    EXPECT_EQ(contentOf(part_), whole.substr(0, 7 + 6 * items)) << length;
  }
}

}  // namespace
}  // namespace forge
