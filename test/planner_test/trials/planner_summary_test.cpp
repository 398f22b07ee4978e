#include "collision_forge/planner_test/trials/planner_summary.h"

#include <gtest/gtest.h>

#include "planner_test/trials/made_results.h"

namespace forge {
namespace {

PlannerSummary summaryOf(const std::vector<PlannerTestResult>& results) {
  return summarizePlanners(results, {"idm"}).at(0);
}

TEST(PlannerSummary, CountsScenesCasesAndHits) {
  const PlannerSummary summary =
      summaryOf({result("s:1", "a", {row("idm", 4.0)}), result("s:2", "a", {row("idm", {})}),
                 result("s:3", "b", {row("idm", 6.0)})});
  EXPECT_EQ(summary.scenes, 2);
  EXPECT_EQ(summary.cases, 3);
  EXPECT_EQ(summary.hits, 2);
}

TEST(PlannerSummary, NamesTheCaseOfTheHardestHit) {
  const PlannerSummary summary =
      summaryOf({result("s:1", "a", {row("idm", 4.0)}), result("s:2", "a", {row("idm", 9.0)}),
                 result("s:3", "b", {row("idm", 6.0)})});
  ASSERT_TRUE(summary.worst);
  EXPECT_DOUBLE_EQ(summary.worst->speed, 9.0);
  EXPECT_EQ(summary.worst->case_name, "s:2");
}

TEST(PlannerSummary, CountsOnlyFairHitsAsAvoidable) {
  std::vector<PlannerTestResult> results = {result("s:1", "a", {row("idm", 4.0)}),
                                            result("s:2", "a", {row("idm", 9.0)}),
                                            result("s:3", "a", {row("idm", {})})};
  results[0].rows[0].is_fair = false;
  EXPECT_EQ(summaryOf(results).avoidable, 1);
}

TEST(PlannerSummary, SeparatesAttackerPolicies) {
  PlannerRow adaptive = row("idm", 4.0);
  adaptive.attacker.policy = PolicyKind::kAdaptive;
  const std::string name = rowName(RowKey{"idm", PolicyKind::kAdaptive});
  const auto summaries =
      summarizePlanners({result("s:1", "a", {row("idm", {}), adaptive})}, {"idm", name});
  ASSERT_EQ(summaries.size(), 2u);
  EXPECT_EQ(summaries[0].hits, 0);
  EXPECT_EQ(summaries[1].hits, 1);
  EXPECT_EQ(summaries[1].planner, name);
}

TEST(PlannerSummary, CountsTheCasesWhoseVerdictDependsOnTheBackground) {
  const auto both = [](std::optional<double> replayed, std::optional<double> reacting) {
    std::vector<PlannerRow> rows = {row("idm", replayed), row("idm", reacting)};
    rows[1].background = Background::kIdm;
    return rows;
  };
  const std::vector<PlannerTestResult> results = {
      result("s:1", "a", both(4.0, 6.0)), result("s:2", "a", both(4.0, {})),
      result("s:3", "a", both({}, {})), result("s:4", "a", both({}, 3.0))};
  TestPlan plan{{"idm"}, {Background::kReplay, Background::kIdm}, {PolicyKind::kFixed}, {}};
  EXPECT_EQ(backgroundText(results, plan),
            "the verdict depends on the background traffic in 2 of 4 cases: idm 2\n");
  plan.backgrounds = {Background::kIdm};
  EXPECT_EQ(backgroundText(results, plan), "");
}

TEST(PlannerSummary, HasALineForEachPlannerUnderTitles) {
  const auto summaries = summarizePlanners(
      {result("s:1", "a", {row("idm", 4.06), row("rule_based", {})})}, {"idm", "rule_based"});
  EXPECT_EQ(summaryText(summaries, {{"idm", 0.126}}),
            "planner     scenes  cases  hit  avoidable  failed  ms a call  worst impact\n"
            "idm              1      1    1          1       0       0.13  4.1 m/s in s:1\n"
            "rule_based       1      1    0          0       0          -  -\n");
}

}  // namespace
}  // namespace forge
