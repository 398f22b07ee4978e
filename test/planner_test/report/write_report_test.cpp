#include "collision_forge/planner_test/report/write_report.h"

#include <gmock/gmock.h>

#include "collision_forge/io/scenarios/scenario_file.h"
#include "collision_forge/planner_test/report/page_file.h"
#include "collision_forge/planner_test/settings/config.h"
#include "io/logs/nuscenes_fixture.h"
#include "planner_test/report/report_scenes.h"

namespace forge {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string contentOf(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::size_t write(const ReportInputs& inputs, const std::string& folder) {
  static const Config config = loadConfig(COLLISION_FORGE_SOURCE_DIR "/config");
  return writeReportPage(inputs, folder,
                         {config.report, config.drawing, config, config.planners,
                          config.attacked_bag.seconds_after_stand});
}

TEST(PageFile, CountsItsRecords) {
  const TemporaryFolder folder;
  PageFile page(folder.path() + "/index.html");
  EXPECT_EQ(page.add("{}"), 0u);
  EXPECT_EQ(page.add("{}"), 1u);
  page.commit("{}");
  const std::string content = contentOf(folder.path() + "/index.html");
  EXPECT_THAT(content, HasSubstr("<!doctype html>"));
  EXPECT_THAT(content, HasSubstr("</html>"));
}

TEST(WriteReportPage, FetchesNothingAndRunsNothingElse) {
  const TemporaryFolder folder;
  folder.write("a.jsonl", scenarioLine(rearEnd()) + "\n");
  write({{folder.path() + "/a.jsonl"}, {}}, folder.path());
  const std::string content = contentOf(folder.path() + "/index.html");
  EXPECT_THAT(content, HasSubstr("default-src 'none'"));
  EXPECT_THAT(content, Not(HasSubstr("unsafe-inline")));
  EXPECT_THAT(content, Not(HasSubstr("{policy}")));
}

TEST(WriteReportPage, NamesTheLineThatIsWrong) {
  const TemporaryFolder folder;
  folder.write("a.jsonl",
               scenarioLine(rearEnd()) + "\n{\"format\":\"collision_forge/scenario\"}\n");
  try {
    write({{folder.path() + "/a.jsonl"}, {}}, folder.path());
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("a.jsonl: line 2"));
  }
  EXPECT_EQ(contentOf(folder.path() + "/index.html"), "");
}

}  // namespace
}  // namespace forge
