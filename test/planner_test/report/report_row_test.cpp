#include "collision_forge/planner_test/report/report_row.h"

#include <gmock/gmock.h>

#include "planner_test/report/report_scenes.h"

namespace forge {
namespace {

using testing::HasSubstr;

PlannerTestResult tested(bool is_hit) {
  PlannerTestResult result;
  result.scene = "straight";
  result.now = kNow;
  result.status = "OK";
  PlannerRow& row = result.rows.emplace_back();
  row.planner = "idm";
  row.outcome.contact = PlannerContact();
  row.outcome.contact->is_attacker = is_hit;
  row.outcome.contact->time = kNow + 1.0;
  return result;
}

TEST(RowOfAttack, HasOutcomeGeneratedWithoutTheRecording) {
  const Scenario scenario = rearEnd();
  const ReportRow row = rowOfAttack(scenario, scenario.answer, {});
  EXPECT_EQ(row.outcome, "generated");
  EXPECT_EQ(row.type, "rear_end");
  EXPECT_DOUBLE_EQ(*row.contact_t, 2.0);
  EXPECT_EQ(row.believable, "yes");
}

TEST(RowOfAttack, HasTheOutcomeInTheRecording) {
  const Scenario scenario = rearEnd();
  StrictOutcome recorded;
  EXPECT_EQ(rowOfAttack(scenario, scenario.answer, recorded).outcome, "missed");
  recorded.report = scenario.answer.report;
  EXPECT_EQ(rowOfAttack(scenario, scenario.answer, recorded).outcome, "otherwise");
  recorded.full_type_kept = true;
  EXPECT_EQ(rowOfAttack(scenario, scenario.answer, recorded).outcome, "as_asked");
}

TEST(RowOfAttack, HasTheContactInTheRecordingIfKnown) {
  const Scenario scenario = rearEnd();
  StrictOutcome recorded;
  recorded.report.contact = true;
  recorded.report.contact_time = kNow + 2.25;
  recorded.report.impact_speed = 4.0;
  const ReportRow row = rowOfAttack(scenario, scenario.answer, recorded);
  EXPECT_DOUBLE_EQ(*row.contact_t, 2.25);
  EXPECT_DOUBLE_EQ(*row.impact_speed, 4.0);
  const ReportRow missed = rowOfAttack(scenario, scenario.answer, StrictOutcome());
  EXPECT_FALSE(missed.contact_t);
  EXPECT_FALSE(missed.impact_speed);
}

TEST(RowOfAttack, KeepsCodeAndReasonOfARejectedRequest) {
  Scenario scenario = rearEnd();
  scenario.answer.status = {StatusCode::kNoCandidate, "nobody is near"};
  const ReportRow row = rowOfAttack(scenario, scenario.answer, {});
  EXPECT_EQ(row.outcome, "declined");
  EXPECT_EQ(row.status, "NO_CANDIDATE");
  EXPECT_EQ(row.message, "nobody is near");
  EXPECT_FALSE(row.contact_t);
}

TEST(RowOfTest, DistinguishesHitsByAttackerAndOtherAgents) {
  for (const bool is_hit : {true, false}) {
    const PlannerTestResult result = tested(is_hit);
    EXPECT_EQ(rowOfTest(result, &result.rows[0], nullptr).outcome, is_hit ? "hit" : "hit_other");
  }
  PlannerTestResult result = tested(true);
  result.rows[0].outcome.contact.reset();
  EXPECT_EQ(rowOfTest(result, &result.rows[0], nullptr).outcome, "clear");
  result.rows[0].outcome.failure = PlannerFailure::kEmpty;
  EXPECT_EQ(rowOfTest(result, &result.rows[0], nullptr).outcome, "failed");
}

TEST(RowOfTest, CopiesTheFieldsOfItsAttack) {
  const Scenario scenario = rearEnd();
  ReportRow attack = rowOfAttack(scenario, scenario.answer, {});
  attack.attack = 7.0;
  attack.commands = 8.0;
  const PlannerTestResult result = tested(true);
  const ReportRow row = rowOfTest(result, &result.rows[0], &attack);
  EXPECT_EQ(row.attack, 7.0);
  EXPECT_FALSE(row.commands) << "commands of the attack do not test the planner";
  EXPECT_EQ(row.manoeuvre, attack.manoeuvre);
  EXPECT_DOUBLE_EQ(*row.contact_t, 1.0);
  EXPECT_EQ(row.planner, "idm");
}

TEST(RowOfTest, HasTheReasonOfAnUnreadableCase) {
  PlannerTestResult result;
  result.status = kUnreadable;
  result.message = "no JSON";
  const ReportRow row = rowOfTest(result, nullptr, nullptr);
  EXPECT_EQ(row.outcome, "untested");
  EXPECT_EQ(row.message, "no JSON");
  EXPECT_FALSE(row.tta);
}

/// Both round to 9.7 directly, but to 9.8 via 9.75.
TEST(WriteColumns, DoNotRoundTwice) {
  ReportRow row;
  row.impact_speed = 9.7481;
  row.contact_t = 9.7496;
  JsonLineWriter writer;
  writer.beginObject();
  writeColumns(writer, {row});
  writer.endObject();
  EXPECT_THAT(writer.line(), HasSubstr(R"("impact_speed":{"unit":1e-06,"missing":-1e+15,)"
                                       R"("values":[9748100]})"));
  EXPECT_THAT(writer.line(), HasSubstr(R"("contact_t":{"unit":1e-06,"missing":-1e+15,)"
                                       R"("values":[9749600]})"));
}

}  // namespace
}  // namespace forge
