#include "collision_forge/planner_test/trials/planner_result_file.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "collision_forge/io/json/json_line.h"
#include "planner_test/trials/rear_end_case.h"

namespace forge {
namespace {

TEST(PlannerResultFile, ALineReadsBackAsTheSameLine) {
  PlannerTestResult result = tested();
  result.rows[1].outcome.failure = PlannerFailure::kNotFinite;
  result.rows[1].outcome.failure_message = "point 3 is not finite";
  result.rows[1].outcome.contact.reset();
  result.rows[1].published_hit.reset();
  result.rows[1].attacker = {
      PolicyKind::kAdaptive, AttackerPhase::kDrivingOn, 7, "max_jerk 9 > 8", "somebody", true};
  result.rows[1].evasion = AvoidabilitySummary{true, {}, EvasiveManoeuvre::kBoth, 2.5, 0.25};
  dropMotions(result);
  result.rows[1].is_fair = false;
  const std::string line = plannerResultLine(result);
  const PlannerTestResult read = readPlannerResultLine("here", line);
  EXPECT_EQ(read.rows.size(), 2u);
  EXPECT_EQ(read.rows[0].outcome.contact->impact_speed,
            result.rows[0].outcome.contact->impact_speed);
  const CrashSeverity& severity = result.rows[0].outcome.contact->severity;
  EXPECT_GT(severity.ego.delta_v, 0.0);
  EXPECT_EQ(read.rows[0].outcome.contact->severity.ego.delta_v, severity.ego.delta_v);
  EXPECT_EQ(read.rows[0].outcome.contact->severity.other.curve, severity.other.curve);
  EXPECT_EQ(read.rows[0].outcome.careful_drivers.size(), 4u);
  EXPECT_EQ(read.careful_drivers.size(), 4u);
  EXPECT_EQ(read.rows[1].outcome.failure, PlannerFailure::kNotFinite);
  EXPECT_EQ(read.avoidability.from_now, result.avoidability.from_now);
  EXPECT_EQ(read.avoidability.last, result.avoidability.last);
  EXPECT_EQ(read.rows[1].attacker.policy, PolicyKind::kAdaptive);
  EXPECT_EQ(read.rows[1].attacker.phase, AttackerPhase::kDrivingOn);
  EXPECT_EQ(read.rows[1].attacker.broken_limit, "max_jerk 9 > 8");
  EXPECT_TRUE(read.rows[0].evasion);
  EXPECT_TRUE(read.rows[0].is_fair);
  ASSERT_TRUE(read.rows[1].evasion);
  EXPECT_EQ(read.rows[1].evasion->last_after, 2.5);
  EXPECT_FALSE(read.rows[1].is_fair);
  EXPECT_EQ(plannerResultLine(read), line);
}

TEST(PlannerResultFile, KeepsTheMotionsToTheMicrometre) {
  PlannerCase one = rearEnd();
  one.request.crash.limits = LimitSet::kDrivable;
  const TestPlan plan{{"idm"}, {Background::kIdm}, {PolicyKind::kAdaptive}, {}};
  PlannerTestResult result = testPlanners(one, plan, config(), config().planners);
  PlannerRow& row = result.rows.front();
  ASSERT_TRUE(row.evasion_drive);
  Track& agent = row.outcome.others.emplace_back();
  agent.id = "reacts";
  agent.states = {{result.now, {1.0, 2.0, 0.0}, {3.0, 0.0}}};
  const std::string line = plannerResultLine(result);
  const PlannerTestResult read = readPlannerResultLine("here", line);
  const PlannerRow& kept = read.rows.front();
  EXPECT_EQ(plannerResultLine(read), line);
  EXPECT_EQ(kept.background, Background::kIdm);
  const auto expect_same = [](const std::vector<TrajectoryPoint>& found,
                              const std::vector<TrajectoryPoint>& expected) {
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_NEAR(found[i].time, expected[i].time, 1e-6);
      EXPECT_LT((found[i].pose.position() - expected[i].pose.position()).norm(), 2e-6);
      EXPECT_NEAR(found[i].pose.yaw, expected[i].pose.yaw, 1e-6);
      EXPECT_NEAR(found[i].speed, expected[i].speed, 1e-6);
      EXPECT_NEAR(found[i].acceleration, expected[i].acceleration, 1e-6);
    }
  };
  expect_same(kept.outcome.driven, row.outcome.driven);
  expect_same(kept.outcome.attacker.points, row.outcome.attacker.points);
  expect_same(kept.evasion_drive->ego.motion, row.evasion_drive->ego.motion);
  expect_same(kept.evasion_drive->attacker.points, row.evasion_drive->attacker.points);
  EXPECT_EQ(kept.evasion_drive->ego.manoeuvre, row.evasion_drive->ego.manoeuvre);
  EXPECT_NEAR(kept.evasion_drive->ego.start, row.evasion_drive->ego.start, 1e-6);
  ASSERT_EQ(kept.outcome.attacker_plans.size(), row.outcome.attacker_plans.size());
  EXPECT_EQ(kept.outcome.attacker_plans.back().phase, row.outcome.attacker_plans.back().phase);
  expect_same(kept.outcome.attacker_plans.back().points, row.outcome.attacker_plans.back().points);
  ASSERT_EQ(kept.outcome.others.size(), row.outcome.others.size());
  EXPECT_EQ(kept.outcome.others.back().id, "reacts");
  EXPECT_EQ(kept.outcome.others.back().states.front().velocity, Vector2(3.0, 0.0));
}

TEST(PlannerResultFile, AMotionWithListsOfDifferentLengthIsRejected) {
  std::string line = plannerResultLine(tested());
  const std::size_t list = line.find("\"t\":[", line.find("\"drive\""));
  line.insert(line.find('[', list) + 1, "0,");
  EXPECT_THROW(readPlannerResultLine("here", line), JsonLineError);
}

TEST(PlannerResultFile, AnotherFormatIsRejectedWithTheField) {
  std::string line = plannerResultLine(tested());
  line.replace(line.find("\"version\":8"), 11, "\"version\":2");
  try {
    readPlannerResultLine("results.jsonl: line 4", line);
    ADD_FAILURE();
  } catch (const JsonLineError& error) {
    EXPECT_NE(std::string(error.what()).find("line 4"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("version"), std::string::npos);
  }
}

TEST(PlannerResultFile, CsvRowsHaveTheColumnsOfTheHeader) {
  const auto commas = [](const std::string& text) {
    return std::count(text.begin(), text.end(), ',');
  };
  PlannerTestResult result = tested();
  result.rows[1].outcome.contact.reset();
  const auto rows = plannerResultCsvRows(result);
  ASSERT_EQ(rows.size(), 2u);
  const auto expected = commas(plannerResultCsvHeader());
  for (const std::string& row : rows) EXPECT_EQ(commas(row), expected) << row;
  result = tested();
  result.name = "a,b.jsonl:1";
  result.source = "a,b";
  result.rows[0].attacker.touched = "c,d\ne";
  for (const std::string& row : plannerResultCsvRows(result)) {
    EXPECT_EQ(commas(row), expected) << row;
    EXPECT_EQ(row.find('\n'), std::string::npos) << row;
  }
  const auto unfit = plannerResultCsvRows(untested(rearEnd(), "UNFIT", "why"));
  ASSERT_EQ(unfit.size(), 1u);
  EXPECT_EQ(commas(unfit[0]), expected);
  EXPECT_EQ(commas(plannerResultCsvRows(untested({}, kUnreadable, "why"))[0]), expected);
}

}  // namespace
}  // namespace forge
