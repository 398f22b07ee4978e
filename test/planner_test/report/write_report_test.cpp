#include "collision_forge/planner_test/report/write_report.h"

#include <gmock/gmock.h>

#include "collision_forge/io/scenarios/scenario_file.h"
#include "collision_forge/planner_test/report/page_file.h"
#include "collision_forge/planner_test/settings/config.h"
#include "collision_forge/planner_test/trials/planner_result_file.h"
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
  return writeReportPage(
      inputs, folder,
      {config.report, config.drawing, config, config.attacked_bag.seconds_after_stand});
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

TEST(WriteReportPage, ContainsTheMotionOfATestIfItsScenarioFileIsAnInput) {
  const TemporaryFolder folder;
  PlannerTestResult test;
  test.name = "a:1";
  test.status = "OK";
  test.now = rearEnd().asked.now;
  PlannerRow& row = test.rows.emplace_back();
  row.planner = "idm";
  row.outcome.driven = rearEnd().answer.trajectory.points;
  folder.write("a.jsonl", scenarioLine(rearEnd()) + "\n");
  const auto size_of_page = [&](const std::vector<std::string>& files) {
    folder.write("results.jsonl", plannerResultLine(test) + "\n");
    write({files, {}}, folder.path() + "/page");
    return contentOf(folder.path() + "/page/index.html").size();
  };
  const std::string attacks = folder.path() + "/a.jsonl";
  const std::string results = folder.path() + "/results.jsonl";
  const std::size_t alone = size_of_page({results});
  const std::size_t with_attack = size_of_page({attacks, results});
  dropMotions(test);
  EXPECT_EQ(size_of_page({results}), alone);
  EXPECT_LT(size_of_page({attacks, results}), with_attack);
}

TEST(WriteReportPage, AllowsNoOtherScriptsAndNoRequests) {
  const TemporaryFolder folder;
  folder.write("a.jsonl", scenarioLine(rearEnd()) + "\n");
  write({{folder.path() + "/a.jsonl"}, {}}, folder.path());
  const std::string content = contentOf(folder.path() + "/index.html");
  EXPECT_THAT(content, HasSubstr("default-src 'none'"));
  EXPECT_THAT(content, Not(HasSubstr("unsafe-inline")));
  EXPECT_THAT(content, Not(HasSubstr("{policy}")));
}

TEST(WriteReportPage, NamesTheInvalidLine) {
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
