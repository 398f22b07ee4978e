#include "collision_forge/planner_test/trials/planner_comparison.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "planner_test/trials/made_results.h"

namespace forge {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::vector<PlannerTestResult> run(const std::string& planner,
                                   const std::vector<std::optional<double>>& impacts) {
  std::vector<PlannerTestResult> results;
  for (const auto& impact : impacts) {
    results.push_back(
        result("s:" + std::to_string(results.size() + 1), "a", {row(planner, impact)}));
  }
  return results;
}

TEST(CompareRuns, ListsNewlyHitAndNewlyAvoidedCases) {
  const auto rows =
      compareRuns(run("idm", {4.0, {}, 5.0, {}}), run("idm", {{}, 3.0, 5.0, {}, 7.0}));
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].cases, 4);
  EXPECT_THAT(rows[0].newly_avoided, ElementsAre("s:1"));
  EXPECT_THAT(rows[0].newly_hit, ElementsAre("s:2"));
  EXPECT_EQ(rows[0].still_hit, 1);
  EXPECT_THAT(comparisonText(rows), HasSubstr("| idm | 4 | 1 | 1 | 1 | 0 | 1.000 -> 1.000 |"));
  EXPECT_THAT(comparisonText(rows), HasSubstr("idm, newly hit:\n- s:2\n"));
}

TEST(CompareRuns, ListsNewFailures) {
  auto after = run("idm", {4.0, {}});
  after[1].rows[0].outcome.failure = PlannerFailure::kTimedOut;
  EXPECT_THAT(compareRuns(run("idm", {4.0, {}}), after).at(0).newly_failed, ElementsAre("s:2"));
}

TEST(CompareRuns, ComparesTheOnlyPlannersOfTwoRuns) {
  const auto rows = compareRuns(run("idm", {4.0}), run("pdm", {{}}));
  EXPECT_THAT(comparisonText(rows), HasSubstr("| idm -> pdm | 1 | 0 | 1 |"));
}

TEST(CompareRuns, RejectsRunsThatShareNothing) {
  EXPECT_THROW(compareRuns(run("idm", {4.0}), {}), std::invalid_argument);
  EXPECT_THROW(readResults("/no/such/folder"), std::runtime_error);
}

}  // namespace
}  // namespace forge
