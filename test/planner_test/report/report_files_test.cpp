#include "collision_forge/planner_test/report/report_files.h"

#include <gmock/gmock.h>

#include "base/scene/shipped_limits.h"
#include "collision_forge/io/json/json_line.h"
#include "io/logs/nuscenes_fixture.h"
#include "planner_test/report/report_scenes.h"

namespace forge {
namespace {

using testing::HasSubstr;

const std::string kHeader = "name,outcome";

/// A format whose rows have a message text; lines without a comma are not rows.
std::vector<RowFormat> formats() {
  const auto row_of = [](const std::string& line) -> std::optional<ReportRow> {
    if (line.find(',') == std::string::npos) return std::nullopt;
    ReportRow row;
    row.message = line;
    return row;
  };
  return {{kHeader, row_of}};
}

ReportFile opened(const std::string& path, const InputLimits& limits = shippedLimits()) {
  return openReportFile(path, formats(), limits);
}

TEST(OpenReportFile, DetectsTheKindOfAFile) {
  const TemporaryFolder folder;
  folder.write("a", scenarioLine(rearEnd()) + "\n");
  folder.write("b", R"({"format":"collision_forge/planner_test"})");
  folder.write("c", kHeader + "\n");
  EXPECT_EQ(opened(folder.path() + "/a").kind, ReportFileKind::kScenarios);
  EXPECT_EQ(opened(folder.path() + "/b").kind, ReportFileKind::kPlannerTests);
  const ReportFile rows = opened(folder.path() + "/c");
  EXPECT_EQ(rows.kind, ReportFileKind::kRows);
  EXPECT_EQ(rows.format.rowOf("a,b")->message, "a,b");
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

TEST(ReadReportLines, SkipTheHeader) {
  const TemporaryFolder folder;
  folder.write("rows.csv", kHeader + "\none\ntwo\n");
  std::vector<std::string> lines;
  double read = 0.0;
  readReportLines(opened(folder.path() + "/rows.csv"), shippedLimits(),
                  [&](const std::string&, std::size_t line, const std::string& text, double share) {
                    lines.push_back(std::to_string(line) + text);
                    read = share;
                  });
  EXPECT_EQ(lines, (std::vector<std::string>{"2one", "3two"}));
  EXPECT_DOUBLE_EQ(read, 1.0);
}

TEST(LinkTo, IsRelativeAndQuoted) {
  EXPECT_EQ(linkTo("/a/b/c.jsonl", "/a/page"), "../b/c.jsonl");
  EXPECT_EQ(linkTo("/a/page/x \"y\".jsonl", "/a/page"), "x%20%22y%22.jsonl");
  EXPECT_EQ(linkTo("/a/page/javascript:1", "/a/page"), "javascript%3A1");
}

}  // namespace
}  // namespace forge
