#include "collision_forge/planner_test/report/attack_record.h"

#include <gmock/gmock.h>

#include "collision_forge/planner_test/settings/config.h"
#include "collision_forge/planner_test/trials/planner_result_file.h"
#include "planner_test/report/decoded_motion.h"
#include "planner_test/report/report_scenes.h"

namespace forge {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

VerificationOptions shippedOptions() {
  return loadConfig(COLLISION_FORGE_SOURCE_DIR "/config").attack.verification;
}

TEST(AttackRecord, ContainsTheLimitsInTheRequest) {
  Scenario scenario = rearEnd();
  const VerificationOptions options = shippedOptions();
  EXPECT_THAT(attackRecord(scenario, scenario.answer, {}, options), HasSubstr(R"("of":"car")"));
  scenario.asked.request.crash.limits = LimitSet::kStrict;
  EXPECT_THAT(attackRecord(scenario, scenario.answer, {}, options), HasSubstr(R"("of":"strict")"));
}

TEST(AttackRecord, ContainsTheRecordedOutcomeIfKnown) {
  const Scenario scenario = rearEnd();
  const VerificationOptions options = shippedOptions();
  EXPECT_THAT(attackRecord(scenario, scenario.answer, {}, options), Not(HasSubstr("recorded\":{")));
  EXPECT_THAT(attackRecord(scenario, scenario.answer, RecordedOutcome(), options),
              HasSubstr(R"("recorded":{"verified":false,"contact":false)"));
}

/// A rear-end contact of two equal cars 10 s after kNow: the ego at 4 m/s is hit at 8 m/s.
ShownCrash crash() {
  const BoxSize size{4.0, 2.0};
  const double time = kNow + 10.0;
  return {PostCrashMotion({AgentClass::kCar, size, {time, {20.0, 0.0, 0.0}, {4.0, 0.0}}},
                          {AgentClass::kCar, size, {time, {16.0, 0.0, 0.0}, {8.0, 0.0}}},
                          shippedOptions().severity),
          2.0};
}

TEST(AttackRecord, ContainsThePostCrashMotionUntilAfterStandstill) {
  const Scenario scenario = rearEnd();
  const auto record = [&](const RecordedOutcome& recorded) {
    return attackRecord(scenario, scenario.answer, recorded, shippedOptions());
  };
  EXPECT_THAT(record({}), Not(HasSubstr("\"crash\":")));
  const std::string line = record({{}, crash()});
  EXPECT_THAT(line, HasSubstr(R"("crash":{"ego":{"t":[10000,100)"));
  EXPECT_THAT(line, HasSubstr(R"("other":{"t":[10000,100)"));
  const auto motionOf = [&](const std::string& who) {
    const std::size_t begin = line.find('"' + who + "\":{", line.find("\"crash\":"));
    return decodedMotion(line.substr(begin, line.find('}', begin) - begin));
  };
  const DecodedMotion ego = motionOf("ego");
  const DecodedMotion attacker = motionOf("other");
  const PostCrashMotion motion = crash().motion;
  EXPECT_NEAR(ego.t.back(), motion.standTime() + 2.0 - kNow, 1e-3);
  for (std::size_t i = 0; i < ego.t.size(); ++i) {
    EXPECT_NEAR(ego.x[i], motion.egoAt(kNow + ego.t[i]).pose.x, 0.02);
    EXPECT_NEAR(attacker.x[i], motion.attackerAt(kNow + attacker.t[i]).pose.x, 0.02);
  }
}

TEST(AttackRecord, ContainsTheWholeReportOfTheScenarioFile) {
  const Scenario scenario = rearEnd();
  const std::string line = scenarioLine(scenario);
  const std::size_t begin = line.find("\"report\":{");
  ASSERT_NE(begin, std::string::npos);
  const std::string report = line.substr(begin, line.find(",\"alternatives\"", begin) - begin);
  EXPECT_THAT(attackRecord(scenario, scenario.answer, {}, shippedOptions()), HasSubstr(report));
}

TEST(PlannerRecord, ContainsAllFieldsOfTheResultsFile) {
  PlannerTestResult result;
  result.avoidability = {true, {EvasiveManoeuvre::kBraking}, EvasiveManoeuvre::kBoth, 1.5, 0.25};
  PlannerRow row;
  row.evasion = result.avoidability;
  result.rows = {row};
  const std::string line = plannerResultLine(result);
  const std::size_t begin = line.find("\"avoidability\":{");
  const std::size_t rows = line.find("\"planners\":[{");
  ASSERT_NE(rows, std::string::npos);
  const std::string record = plannerRecord(result, row, {});
  const std::size_t end = line.find(",\"careful_drivers\"", begin);  // the page shows the row's
  EXPECT_THAT(record, HasSubstr(line.substr(begin, end - begin)));
  const std::string fields = line.substr(line.find('{', rows) + 1);
  EXPECT_THAT(record, HasSubstr(fields.substr(0, fields.find(",\"drive\":null"))));
}

TEST(PlannerRecord, ContainsTheMotionIfThePageHasTheAttack) {
  PlannerTestResult result;
  result.now = kNow;
  PlannerRow row;
  row.outcome.contact = PlannerContact();
  row.outcome.contact->time = kNow + 1.5;
  row.outcome.driven = rearEnd().answer.trajectory.points;
  EXPECT_THAT(plannerRecord(result, row, {}),
              AllOf(HasSubstr(R"("t":1.5)"), Not(HasSubstr("drive\":"))));
  ShownTest shown{true};
  EXPECT_THAT(plannerRecord(result, row, shown),
              AllOf(HasSubstr(R"("drive":{"ego":{"t":[0,100)"), Not(HasSubstr("\"evasion\":{"))));
  EXPECT_THAT(plannerRecord(result, row, shown), Not(HasSubstr("\"crash\":")));
  shown.crash = crash();
  EXPECT_THAT(plannerRecord(result, row, shown), HasSubstr(R"("crash":{"ego":{"t":[10000,100)"));
  shown.crash->other =
      Track{"parked", AgentClass::kCar, {}, {{kNow, {}}, {kNow + 9.0, {}}, {kNow + 11.0, {}}}};
  EXPECT_THAT(plannerRecord(result, row, shown), HasSubstr(R"("other":{"t":[0,9000,1000,100)"));
  row.evasion_drive =
      Evasion{{EvasiveManoeuvre::kBraking, kNow + 1.0, row.outcome.driven, 0.0}, {}};
  EXPECT_THAT(plannerRecord(result, row, shown), HasSubstr(R"("evasion":{"t":[0,100)"));
}

}  // namespace
}  // namespace forge
