#include "collision_forge/report/report_files.h"

#include <gmock/gmock.h>

#include "collision_forge/data/json_line.h"
#include "collision_forge/study/result_row.h"
#include "data/nuscenes_fixture.h"
#include "report/report_scenes.h"
#include "scene/shipped_limits.h"

namespace forge {
namespace {

using testing::HasSubstr;

TEST(OpenReportFile, KnowsWhatAFileHolds) {
  const TemporaryFolder folder;
  folder.write("a", scenarioLine(rearEnd()) + "\n");
  folder.write("b", R"({"format":"collision_forge/planner_test"})");
  folder.write("c", csvHeader(Protocol::kStrict, RowsOf::kRequests) + "\n");
  EXPECT_EQ(openReportFile(folder.path() + "/a", shippedLimits()).kind, ReportFileKind::kScenarios);
  EXPECT_EQ(openReportFile(folder.path() + "/b", shippedLimits()).kind,
            ReportFileKind::kPlannerTests);
  EXPECT_EQ(openReportFile(folder.path() + "/c", shippedLimits()).kind, ReportFileKind::kRequests);
}

TEST(OpenReportFile, NamesFileAndLineOfAnythingElse) {
  const TemporaryFolder folder;
  folder.write("text", "hello\n");
  folder.write("other", R"({"format":"x"})");
  for (const char* name : {"text", "other", "absent"}) {
    try {
      openReportFile(folder.path() + "/" + name, shippedLimits());
      FAIL() << name;
    } catch (const std::runtime_error& error) {
      EXPECT_THAT(error.what(), HasSubstr(folder.path() + "/" + name));
    }
  }
}

TEST(ReadReportLines, LeaveTheHeaderOut) {
  const TemporaryFolder folder;
  folder.write("rows.csv", csvHeader(Protocol::kStrict, RowsOf::kRequests) + "\none\ntwo\n");
  std::vector<std::string> lines;
  double read = 0.0;
  readReportLines(openReportFile(folder.path() + "/rows.csv", shippedLimits()), shippedLimits(),
                  [&](const std::string&, std::size_t line, const std::string& text, double share) {
                    lines.push_back(std::to_string(line) + text);
                    read = share;
                  });
  EXPECT_EQ(lines, (std::vector<std::string>{"2one", "3two"}));
  EXPECT_DOUBLE_EQ(read, 1.0);
}

TEST(ReadReportLines, AreNoLongerThanTheLimit) {
  const TemporaryFolder folder;
  const std::string header = csvHeader(Protocol::kStrict, RowsOf::kRequests);
  folder.write("rows.csv", header + "\n" + header + ",\n");
  InputLimits limits;
  limits.max_line = static_cast<int>(header.size());
  const ReportFile file = openReportFile(folder.path() + "/rows.csv", limits);
  try {
    readReportLines(file, limits,
                    [](const std::string&, std::size_t, const std::string&, double) {});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("rows.csv: line 2: length = "));
  }
  --limits.max_line;
  EXPECT_THROW(openReportFile(folder.path() + "/rows.csv", limits), InputError);
}

TEST(LinkTo, IsRelativeAndQuoted) {
  EXPECT_EQ(linkTo("/a/b/c.jsonl", "/a/page"), "../b/c.jsonl");
  EXPECT_EQ(linkTo("/a/page/x \"y\".jsonl", "/a/page"), "x%20%22y%22.jsonl");
  EXPECT_EQ(linkTo("/a/page/javascript:1", "/a/page"), "javascript%3A1");
}

}  // namespace
}  // namespace forge
