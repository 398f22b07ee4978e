#include "collision_forge/study/result_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>

#include "data/nuscenes_fixture.h"

namespace forge {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

const std::vector<std::string> kClips = {"one", "two", "three"};

ResultFile::Run sampleRun() {
  return {Protocol::kPublished, kClips, 2, {"split = val", "seeds = 1"}};
}

std::vector<ResultRow> rowsOf(const std::string& clip) {
  ResultRow row;
  row.name = clip;
  row.scene = "scene-0001";
  row.method = "recorded";
  row.status = "OK";
  row.meets = {true, false};
  ResultRow second = row;
  second.method = "nominal";
  return {row, second};
}

std::string textOf(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

class ResultFileTest : public testing::Test {
 protected:
  std::string out() const { return folder_.path() + "/out"; }
  std::string part() const { return out() + "/results.csv.part"; }
  std::string whole() const { return out() + "/results.csv"; }

  /// Writes the rows of the first `count` clips and stops.
  void writeClips(std::size_t count) const {
    ResultFile file(out(), sampleRun());
    file.open();
    for (std::size_t i = file.itemsDone(); i < count; ++i) file.add(rowsOf(kClips[i]));
    if (count == kClips.size()) file.finish();
  }

  /// What opening the folder for `run` says; empty when nothing is wrong.
  std::string complaint(ResultFile::Run run) const {
    try {
      ResultFile(out(), std::move(run));
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  }

  TemporaryFolder folder_;
};

TEST_F(ResultFileTest, FinishedFileHasAllRowsInOrder) {
  writeClips(3);
  EXPECT_FALSE(fs::exists(part()));
  std::string expected = csvHeader(Protocol::kPublished) + "\n";
  for (const std::string& clip : kClips) {
    for (const ResultRow& row : rowsOf(clip)) expected += toCsv(row) + "\n";
  }
  EXPECT_EQ(textOf(whole()), expected);
  EXPECT_EQ(textOf(out() + "/run.txt"), "split = val\nseeds = 1\n");
}

TEST_F(ResultFileTest, UnfinishedFileIsGoneOnWith) {
  writeClips(2);
  EXPECT_FALSE(fs::exists(whole()));
  EXPECT_EQ(ResultFile(out(), sampleRun()).itemsDone(), 2u);
  EXPECT_EQ(ResultFile(out(), sampleRun()).rows().size(), 4u);
  writeClips(3);
  const std::string resumed = textOf(whole());
  fs::remove_all(out());
  writeClips(3);
  EXPECT_EQ(textOf(whole()), resumed);
}

TEST_F(ResultFileTest, ClipThatWasCutOffAnywhereIsDoneAgain) {
  writeClips(3);
  const std::string text = textOf(whole());
  fs::remove(whole());
  for (std::size_t length = 0; length < text.size(); ++length) {
    std::ofstream(part()) << text.substr(0, length);
    const ResultFile file(out(), sampleRun());
    ASSERT_LT(file.itemsDone(), 3u) << length;
    ASSERT_EQ(file.rows().size(), 2 * file.itemsDone());
    writeClips(3);
    ASSERT_EQ(textOf(whole()), text) << length;
    fs::remove(whole());
  }
}

TEST_F(ResultFileTest, FinishedFileIsReadAndLeftAlone) {
  writeClips(3);
  const auto written = fs::last_write_time(whole());
  ResultFile file(out(), sampleRun());
  EXPECT_EQ(file.itemsDone(), 3u);
  file.open();
  file.finish();
  EXPECT_EQ(file.rows().size(), 6u);
  EXPECT_EQ(fs::last_write_time(whole()), written);
  EXPECT_FALSE(fs::exists(part()));
}

TEST_F(ResultFileTest, AnotherRunsResultsAreNotTouched) {
  writeClips(2);
  const std::string before = textOf(part());
  ResultFile::Run other = sampleRun();
  other.description[0] = "split = train";
  EXPECT_THAT(complaint(other), HasSubstr("\"split = val\" there, \"split = train\" now"));
  other.description = {"split = val"};
  EXPECT_THAT(complaint(other), HasSubstr("\"seeds = 1\" there, \"\" now"));
  fs::remove(out() + "/run.txt");
  EXPECT_THAT(complaint(sampleRun()), HasSubstr("run.txt is missing"));
  EXPECT_EQ(textOf(part()), before);
}

TEST_F(ResultFileTest, RowsOfOtherClipsAreRefusedByLine) {
  writeClips(2);
  ResultFile::Run other = sampleRun();
  other.items = {"one", "four", "three"};
  EXPECT_THAT(complaint(other), HasSubstr("line 4: \"two,"));
  other.items = {"one"};
  EXPECT_THAT(complaint(other), HasSubstr("line 4"));
  other = sampleRun();
  other.protocol = Protocol::kStrict;
  EXPECT_THAT(complaint(other), HasSubstr("another header"));
}

TEST_F(ResultFileTest, ShortenedFinishedFileIsAnError) {
  writeClips(3);
  std::ofstream(whole()) << csvHeader(Protocol::kPublished) << "\n";
  EXPECT_THAT(complaint(sampleRun()), HasSubstr("ends before one"));
}

TEST_F(ResultFileTest, FinishingTooEarlyIsAMistake) {
  ResultFile file(out(), sampleRun());
  file.open();
  EXPECT_THROW(file.finish(), std::logic_error);
}

TEST_F(ResultFileTest, LookingAloneMakesNoFolder) {
  const ResultFile file(out(), sampleRun());
  EXPECT_FALSE(fs::exists(out()));
}

}  // namespace
}  // namespace forge
