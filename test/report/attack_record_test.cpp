#include "collision_forge/report/attack_record.h"

#include <gmock/gmock.h>

#include "collision_forge/settings/config.h"
#include "collision_forge/trials/planner_result_file.h"
#include "report/report_scenes.h"

namespace forge {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

VerificationOptions shippedOptions() {
  return loadConfig(COLLISION_FORGE_SOURCE_DIR "/config").attack.verification;
}

TEST(AttackRecord, TellsTheLimitsThatTheRequestAsksFor) {
  Scenario scenario = rearEnd();
  const VerificationOptions options = shippedOptions();
  EXPECT_THAT(attackRecord(scenario, scenario.answer, {}, options), HasSubstr(R"("of":"car")"));
  scenario.asked.request.crash.limits = LimitSet::kStrict;
  EXPECT_THAT(attackRecord(scenario, scenario.answer, {}, options), HasSubstr(R"("of":"strict")"));
}

TEST(AttackRecord, HasWhatTheRecordingSaysWhereThatIsKnown) {
  const Scenario scenario = rearEnd();
  const VerificationOptions options = shippedOptions();
  EXPECT_THAT(attackRecord(scenario, scenario.answer, {}, options), Not(HasSubstr("recorded\":{")));
  EXPECT_THAT(attackRecord(scenario, scenario.answer, CollisionReport(), options),
              HasSubstr(R"("recorded":{"verified":false,"contact":false)"));
}

TEST(AttackRecord, TellsAllOfTheReportThatTheScenarioFileDoes) {
  const Scenario scenario = rearEnd();
  const std::string line = scenarioLine(scenario);
  const std::size_t begin = line.find("\"report\":{");
  ASSERT_NE(begin, std::string::npos);
  const std::string report = line.substr(begin, line.find(",\"alternatives\"", begin) - begin);
  EXPECT_THAT(attackRecord(scenario, scenario.answer, {}, shippedOptions()), HasSubstr(report));
}

TEST(PlannerRecord, TellsAllThatTheFileOfResultsDoes) {
  PlannerTestResult result;
  result.avoidability = {true, {EvasiveManoeuvre::kBraking}, EvasiveManoeuvre::kBoth, 1.5, 0.25};
  PlannerRow row;
  row.escape = result.avoidability;
  result.rows = {row};
  const std::string line = plannerResultLine(result);
  const std::size_t begin = line.find("\"avoidability\":{");
  const std::size_t rows = line.find("\"planners\":[{");
  ASSERT_NE(rows, std::string::npos);
  const std::string record = plannerRecord(result, row, {});
  EXPECT_THAT(record, HasSubstr(line.substr(begin, rows - begin)));
  const std::string fields = line.substr(line.find('{', rows) + 1);
  EXPECT_THAT(record, HasSubstr(fields.substr(0, fields.size() - 3)));  // without }]}
}

TEST(PlannerRecord, HasTheMotionWhereItWasDrivenAgain) {
  PlannerTestResult result;
  result.now = kNow;
  PlannerRow row;
  row.outcome.contact = PlannerContact();
  row.outcome.contact->time = kNow + 1.5;
  EXPECT_THAT(plannerRecord(result, row, {}),
              AllOf(HasSubstr(R"("t":1.5)"), Not(HasSubstr("drive\":"))));
  ShownTest shown{row.outcome};
  shown.driven->driven = rearEnd().answer.trajectory.points;
  EXPECT_THAT(plannerRecord(result, row, shown),
              AllOf(HasSubstr(R"("drive":{"ego":{"t":[0,100)"), Not(HasSubstr("\"escape\":{"))));
  shown.escape = Escape{{EvasiveManoeuvre::kBraking, kNow + 1.0, shown.driven->driven, 0.0}, {}};
  EXPECT_THAT(plannerRecord(result, row, shown), HasSubstr(R"("escape":{"t":[0,100)"));
}

TEST(PlannerRecord, LinksToPictures) {
  ShownTest shown;
  shown.pictures = {{"The hit", "../worst/idm_fixed_1.gif"}};
  EXPECT_THAT(plannerRecord(PlannerTestResult(), PlannerRow(), shown),
              HasSubstr(R"("pictures":[{"name":"The hit","link":"../worst/idm_fixed_1.gif"}])"));
}

}  // namespace
}  // namespace forge
