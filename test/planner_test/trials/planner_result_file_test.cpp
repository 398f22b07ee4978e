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
  result.rows[1].escape = AvoidabilitySummary{true, {}, EvasiveManoeuvre::kBoth, 2.5, 0.25};
  result.rows[1].is_fair = false;
  const std::string line = plannerResultLine(result);
  const PlannerTestResult read = readPlannerResultLine("here", line);
  EXPECT_EQ(read.rows.size(), 2u);
  EXPECT_EQ(read.rows[0].outcome.contact->impact_speed,
            result.rows[0].outcome.contact->impact_speed);
  EXPECT_EQ(read.rows[1].outcome.failure, PlannerFailure::kNotFinite);
  EXPECT_EQ(read.avoidability.from_now, result.avoidability.from_now);
  EXPECT_EQ(read.avoidability.last, result.avoidability.last);
  EXPECT_EQ(read.rows[1].attacker.policy, PolicyKind::kAdaptive);
  EXPECT_EQ(read.rows[1].attacker.phase, AttackerPhase::kDrivingOn);
  EXPECT_EQ(read.rows[1].attacker.broken_limit, "max_jerk 9 > 8");
  EXPECT_TRUE(read.rows[0].escape);
  EXPECT_TRUE(read.rows[0].is_fair);
  ASSERT_TRUE(read.rows[1].escape);
  EXPECT_EQ(read.rows[1].escape->last_after, 2.5);
  EXPECT_FALSE(read.rows[1].is_fair);
  EXPECT_EQ(plannerResultLine(read), line);
}

TEST(PlannerResultFile, AnotherFormatIsRefusedByField) {
  std::string line = plannerResultLine(tested());
  line.replace(line.find("\"version\":4"), 11, "\"version\":2");
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
