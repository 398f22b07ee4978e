#include "collision_forge/planner_test/report/report_files.h"

#include <gmock/gmock.h>

#include "base/scene/shipped_limits.h"
#include "collision_forge/io/json/json_line.h"
#include "io/logs/nuscenes_fixture.h"
#include "planner_test/report/report_scenes.h"

namespace forge {
namespace {

using testing::HasSubstr;

ReportFile opened(const std::string& path, const InputLimits& limits = shippedLimits()) {
  return openReportFile(path, limits);
}

TEST(OpenReportFile, DetectsTheKindOfAFile) {
  const TemporaryFolder folder;
  folder.write("a", scenarioLine(rearEnd()) + "\n");
  folder.write("b", R"({"format":"collision_forge/planner_test"})");
  EXPECT_EQ(opened(folder.path() + "/a").kind, ReportFileKind::kScenarios);
  EXPECT_EQ(opened(folder.path() + "/b").kind, ReportFileKind::kPlannerTests);
}

TEST(OpenReportFile, NamesFileAndLineOfAnUnknownFile) {
  const TemporaryFolder folder;
  folder.write("text", "hello\n");
  folder.write("other", R"({"format":"x"})");
  for (const char* name : {"text", "other", "absent"}) {
    try {
      opened(folder.path() + "/" + name);
      FAIL() << name;
    } catch (const std::runtime_error& error) {
      EXPECT_THAT(error.what(), HasSubstr(folder.path() + "/" + name));
    }
  }
}

TEST(ReadReportLines, NumbersTheLinesAndReportsProgress) {
  const TemporaryFolder folder;
  const std::string line = R"({"format":"collision_forge/planner_test"})";
  folder.write("tests", line + "\n" + line + "\n");
  std::vector<std::size_t> lines;
  double read = 0.0;
  readReportLines(
      opened(folder.path() + "/tests"), shippedLimits(),
      [&](const std::string&, std::size_t number, const std::string& text, double share) {
        EXPECT_EQ(text, line);
        lines.push_back(number);
        read = share;
      });
  EXPECT_EQ(lines, (std::vector<std::size_t>{1, 2}));
  EXPECT_DOUBLE_EQ(read, 1.0);
}

TEST(LinkTo, IsRelativeAndQuoted) {
  EXPECT_EQ(linkTo("/a/b/c.jsonl", "/a/page"), "../b/c.jsonl");
  EXPECT_EQ(linkTo("/a/page/x \"y\".jsonl", "/a/page"), "x%20%22y%22.jsonl");
  EXPECT_EQ(linkTo("/a/page/javascript:1", "/a/page"), "javascript%3A1");
}

}  // namespace
}  // namespace forge
