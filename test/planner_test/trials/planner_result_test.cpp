#include "collision_forge/planner_test/trials/planner_result.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "collision_forge/planner_test/trials/planner_result_file.h"
#include "planner_test/trials/rear_end_case.h"

namespace forge {
namespace {

/// A protocol in which the attacker hits only the ego of idm_published.
class HitOfIdm : public PublishedProtocol {
 public:
  bool isHit(const std::vector<TrajectoryPoint>&) const override { return false; }
  bool isIdmHit(const PublishedIdmOptions&) const override { return true; }
};

TEST(PlannerResult, EveryPlannerHasARow) {
  const PlannerTestResult result = tested();
  EXPECT_EQ(result.status, "OK");
  EXPECT_TRUE(result.is_strict);
  EXPECT_TRUE(result.avoidability.is_avoidable);
  ASSERT_EQ(result.rows.size(), 2u);
  EXPECT_EQ(result.rows[0].planner, "idm");
  // IDM accelerates by at most 1 m/s2 and ignores agents behind the ego.
  ASSERT_TRUE(result.rows[0].outcome.contact);
  EXPECT_TRUE(result.rows[0].outcome.contact->is_attacker);
  EXPECT_FALSE(result.rows[0].outcome.contact->at_fault);
  EXPECT_EQ(result.rows[0].published_hit, true);
}

TEST(PlannerResult, EachPolicyOfTheAttackerHasARowOfItsOwn) {
  PlannerCase one = rearEnd();
  one.request.crash.limits = LimitSet::kDrivable;
  const TestPlan plan{
      {"idm", "pdm"}, {Background::kReplay}, {PolicyKind::kFixed, PolicyKind::kAdaptive}, {}};
  const PlannerTestResult result = testPlanners(one, plan, config(), config().planners);
  ASSERT_EQ(result.rows.size(), 4u);
  const std::vector<std::string> names = rowNames(plan);
  for (std::size_t i = 0; i < names.size(); ++i) {
    const PlannerRow& row = result.rows[i];
    EXPECT_EQ(rowName(row), names[i]);
    EXPECT_EQ(names[i].find(','), std::string::npos) << "it is a cell of CSV files";
    EXPECT_EQ(row.attacker.broken_limit, "");
    EXPECT_EQ(row.published_hit.has_value(), row.attacker.policy == PolicyKind::kFixed);
  }
  one.request.crash.limits = LimitSet::kStrict;
  const PlannerTestResult strict = testPlanners(one, plan, config(), config().planners);
  EXPECT_EQ(strict.rows[1].attacker.broken_limit, "") << "it drives by the limits of its class";
  EXPECT_TRUE(result.rows[1].attacker.as_asked) << "IDM, hit by an adaptive attacker";
  ASSERT_TRUE(result.rows[1].evasion);
  EXPECT_TRUE(result.rows[1].evasion->is_avoidable);
  EXPECT_TRUE(result.rows[1].is_fair);
  EXPECT_EQ(result.rows[0].evasion.has_value(),
            result.rows[0].outcome.contact && result.rows[0].outcome.contact->is_attacker);
}

TEST(PlannerResult, EachBackgroundHasARowOfItsOwn) {
  const TestPlan plan{{"idm"}, {Background::kReplay, Background::kIdm}, {PolicyKind::kFixed}, {}};
  EXPECT_EQ(rowNames(plan), (std::vector<std::string>{"idm", "idm in idm traffic"}));
  const PlannerTestResult result = testPlanners(rearEnd(), plan, config(), config().planners);
  ASSERT_EQ(result.rows.size(), 2u);
  EXPECT_EQ(result.rows[0].background, Background::kReplay);
  EXPECT_EQ(result.rows[1].background, Background::kIdm);
  EXPECT_EQ(rowName(result.rows[1]), "idm in idm traffic");
}

TEST(PlannerResult, AHitAvoidableForLessThanAvoidableForIsUnfair) {
  PlannerCase one = rearEnd();
  Config strict = config();
  strict.adaptive.fairness.avoidable_for = one.request.tta;
  const PlannerTestResult result = testPlanners(one, {{"idm"}}, strict, strict.planners);
  ASSERT_TRUE(result.rows[0].outcome.contact);
  ASSERT_TRUE(result.rows[0].evasion);
  EXPECT_LT(result.rows[0].evasion->last_after, one.request.tta);
  EXPECT_FALSE(result.rows[0].is_fair);
}

TEST(PlannerResult, ACaseWithoutAnAttackIsNotTested) {
  PlannerCase one = rearEnd();
  one.status = {StatusCode::kNoCandidate, "nobody"};
  const PlannerTestResult result = testPlanners(one, {{"idm"}}, config(), config().planners);
  EXPECT_EQ(result.status, "NO_CANDIDATE");
  EXPECT_EQ(result.message, "nobody");
  EXPECT_FALSE(result.isTested());
  EXPECT_TRUE(result.rows.empty());
}

TEST(PlannerResult, AnAttackerThatTouchesTheEgoAtT0IsUnfit) {
  PlannerCase one = rearEnd();
  one.scenario.attacker.points.front().pose = {-3.0, 0.0, 0.0};
  const PlannerTestResult result = testPlanners(one, {{"idm"}}, config(), config().planners);
  EXPECT_EQ(result.status, "UNFIT");
  EXPECT_NE(result.message.find("touches the ego"), std::string::npos);
}

TEST(PlannerResult, AnUnfitClipHasThePublishedHitOfIdmPublished) {
  PlannerCase one = rearEnd();
  one.scenario.attacker.points.front().pose = {-3.0, 0.0, 0.0};
  one.published = std::make_shared<HitOfIdm>();
  const PlannerTestResult result =
      testPlanners(one, {{"idm", "idm_published"}}, config(), config().planners);
  EXPECT_EQ(result.status, "UNFIT");
  ASSERT_EQ(result.rows.size(), 1u);
  EXPECT_EQ(result.rows[0].planner, "idm_published");
  EXPECT_EQ(result.rows[0].published_hit, std::optional<bool>(true));
  const auto csv = plannerResultCsvRows(result);
  ASSERT_EQ(csv.size(), 1u);
  const std::string header = plannerResultCsvHeader();
  EXPECT_EQ(std::count(csv[0].begin(), csv[0].end(), ','),
            std::count(header.begin(), header.end(), ','));
  EXPECT_EQ(csv[0].back(), '1');
}

}  // namespace
}  // namespace forge
