#include "collision_forge/planner_test/trials/planner_tuning.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "attack/search/test_scenes.h"
#include "collision_forge/base/config/config_error.h"
#include "collision_forge/study/evaluation/clip_cases.h"
#include "collision_forge/study/settings/study_config.h"
#include "io/collide/collide_fixture.h"

namespace forge {
namespace {

const std::string kConfig = COLLISION_FORGE_SOURCE_DIR "/config";

const StudyConfig& config() {
  static const StudyConfig loaded = loadStudyConfig(kConfig);
  return loaded;
}

std::vector<PlannerVariant> variants(const PlannerGrid& grid) {
  std::ifstream file(kConfig + "/planners.yaml");
  std::ostringstream text;
  text << file.rdbuf();
  return variantsOf(grid, "planners.yaml", text.str(), config().attack.verification.limits);
}

enum class End { kFree, kAttacker, kAtFault, kInnocent, kFailure };

PlannerRow row(const std::string& name, End end, double progress = 0.0) {
  PlannerRow found{name, {}, {}};
  found.outcome.progress = progress;
  if (end == End::kFailure) found.outcome.failure = PlannerFailure::kOffMap;
  if (end == End::kFree || end == End::kFailure) return found;
  PlannerContact contact;
  contact.is_attacker = end == End::kAttacker;
  contact.at_fault = end == End::kAtFault;
  found.outcome.contact = contact;
  return found;
}

PlannerTestResult result(const std::string& scene, std::vector<PlannerRow> rows,
                         bool is_avoidable = true) {
  PlannerTestResult one;
  one.name = scene;
  one.scene = scene;
  one.source = "history";
  one.tta = 4.0;
  one.status = "OK";
  one.avoidability.is_avoidable = is_avoidable;
  one.rows = std::move(rows);
  return one;
}

std::vector<PlannerVariant> named(const std::vector<std::string>& names) {
  std::vector<PlannerVariant> found;
  for (const std::string& name : names) found.push_back({name, {{"a.b", 1.5}}, {}});
  return found;
}

VariantScore score(double collision, double progress) {
  return {{10, collision, Interval{0.0, 1.0}}, progress};
}

/// The attacker comes from behind at twice the ego's speed.
PlannerCase rearEnd() {
  const CollideClip clip =
      straightClip(CollisionType::kRearEnd, 0.0, 11, 5.0, {-14.7, 0.0, 0.0}, 10.0);
  PlannerCase one =
      caseOfClip(clip, ClipAttacker::kRecorded, std::make_shared<const LaneIndex>(twoLaneRoad()),
                 MethodMaker("search", builtInMethods(), config().attack, {}), config());
  one.published.reset();
  return one;
}

TEST(Combinations, StartWithTheDefaults) {
  const PlannerGrid grid = {{"a", {1.0, 2.0}}, {"b", {3.0, 4.0, 5.0}}};
  const std::vector<PlannerValues> expected = {{{"a", 1.0}, {"b", 4.0}}, {{"a", 1.0}, {"b", 3.0}},
                                               {{"a", 1.0}, {"b", 5.0}}, {{"a", 2.0}, {"b", 3.0}},
                                               {{"a", 2.0}, {"b", 4.0}}, {{"a", 2.0}, {"b", 5.0}}};
  EXPECT_EQ(combinationsOf(grid, {{"a", 1.0}, {"b", 4.0}}), expected);
}

TEST(Variants, HaveTheirValuesInTheirOptions) {
  const auto found =
      variants({{"pdm.idm.min_gap", {1.0, 4.0}}, {"pdm.scoring.ttc_weight", {2.5, 5.0}}});
  ASSERT_EQ(found.size(), 4u);
  EXPECT_EQ(found[0].name, "default");
  EXPECT_EQ(found[0].options.pdm.idm.min_gap, 1.0);
  EXPECT_EQ(found[0].options.pdm.scoring.ttc_weight, 5.0);
  EXPECT_EQ(found[2].name, "2");
  EXPECT_EQ(found[2].options.pdm.idm.min_gap, 4.0);
  EXPECT_EQ(found[2].options.pdm.scoring.ttc_weight, 2.5);
  EXPECT_EQ(found[2].options.pdm.idm.max_acceleration, 1.5);
}

TEST(Variants, LeaveReactiveTrafficUnchanged) {
  const auto found = variants({{"idm.standard.min_gap", {1.0, 4.0}}});
  ASSERT_EQ(found.back().options.idm.law.min_gap, 4.0);
  for (const PlannerVariant& variant : found) {
    EXPECT_EQ(variant.options.traffic.law.min_gap, config().planners.idm.law.min_gap)
        << variant.name;
  }
}

TEST(HeldOut, RejectsASceneInBothSets) {
  EXPECT_NO_THROW(checkHeldOut({"a", "b"}, {"c"}));
  try {
    checkHeldOut({"a", "b"}, {"b", "c"});
    ADD_FAILURE();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("\"b\""), std::string::npos);
  }
}

TEST(Collision, IsWithTheAttackerOrAtFaultOrAFailure) {
  EXPECT_FALSE(isCollision(row("x", End::kFree).outcome));
  EXPECT_TRUE(isCollision(row("x", End::kAttacker).outcome));
  EXPECT_TRUE(isCollision(row("x", End::kAtFault).outcome));
  EXPECT_FALSE(isCollision(row("x", End::kInnocent).outcome));
  EXPECT_TRUE(isCollision(row("x", End::kFailure).outcome));
}

TEST(VariantScores, CountOnlyAvoidableCrashes) {
  PlannerTestResult declined = result("d", {});
  declined.status = "NO_CANDIDATE";
  const std::vector<PlannerTestResult> results = {
      result("a", {row("default", End::kAttacker, 2.0), row("1", End::kFree, 8.0)}),
      result("b", {row("default", End::kFree, 6.0), row("1", End::kFree, 10.0)}),
      result("c", {row("default", End::kAttacker, 90.0), row("1", End::kAttacker, 90.0)}, false),
      declined};
  const auto scores = scoreVariants(results, named({"default", "1"}));
  ASSERT_EQ(scores.size(), 2u);
  EXPECT_EQ(scores[0].collision.trials, 2);
  EXPECT_DOUBLE_EQ(scores[0].collision.value, 0.5);
  EXPECT_DOUBLE_EQ(scores[0].progress, 4.0);
  EXPECT_DOUBLE_EQ(scores[1].collision.value, 0.0);
  EXPECT_DOUBLE_EQ(scores[1].progress, 9.0);
}

TEST(BestVariant, IsOrderedByRateThenProgressThenIndex) {
  EXPECT_EQ(bestVariant({score(0.3, 9.0), score(0.2, 1.0), score(0.4, 9.0)}), 1u);
  EXPECT_EQ(bestVariant({score(0.2, 5.0), score(0.2, 4.0), score(0.2, 6.0)}), 2u);
  EXPECT_EQ(bestVariant({score(0.2, 5.0), score(0.2, 5.0)}), 0u);
}

TEST(Comparison, ShowsBothRatesAndThePairedDifference) {
  const RateTable table = comparisonTable(
      {result("a", {row("default", End::kAttacker), row("tuned", End::kFree)}),
       result("b", {row("default", End::kAttacker), row("tuned", End::kAtFault)}),
       result("c", {row("default", End::kFree), row("tuned", End::kFree)}),
       result("d", {row("default", End::kAttacker), row("tuned", End::kFree)}),
       result("e", {row("default", End::kFree), row("tuned", End::kAttacker)}, false)});
  EXPECT_EQ(table.methods, (std::vector<std::string>{"default", "tuned", "tuned - default"}));
  EXPECT_EQ(table.rates[0].back().trials, 4);
  EXPECT_DOUBLE_EQ(table.rates[0].back().value, 0.75);
  EXPECT_DOUBLE_EQ(table.rates[1].back().value, 0.25);
  EXPECT_DOUBLE_EQ(table.rates[2].back().value, -0.5);
}

TEST(TestVariants, HasARowPerVariant) {
  const auto both = variants({{"idm.standard.max_acceleration", {5.0}}});
  const PlannerTestResult found =
      testVariants(rearEnd(), "idm", both, true, Background::kReplay, config(), config().planners);
  ASSERT_EQ(found.rows.size(), 2u);
  EXPECT_EQ(found.rows[0].planner, "default");
  EXPECT_EQ(found.rows[1].planner, "1");
  // A higher acceleration leads to more progress at any time.
  const auto speed = [](const RolloutOutcome& o) { return o.progress / o.duration; };
  EXPECT_GT(speed(found.rows[1].outcome), speed(found.rows[0].outcome));
}

TEST(TestVariants, CanLeaveOutUnavoidableCases) {
  PlannerCase one = rearEnd();
  const auto only = variants({{"idm.standard.min_gap", {1.0}}});
  TrialOptions helpless = config().planners;
  // Only keeping the speed may be tried, and then the ego is hit from behind.
  helpless.avoidability.accelerations = {0.0};
  helpless.avoidability.offsets = {0.0};
  helpless.avoidability.draws = 0;
  EXPECT_TRUE(
      testVariants(one, "idm", only, true, Background::kReplay, config(), helpless).rows.empty());
  EXPECT_EQ(
      testVariants(one, "idm", only, false, Background::kReplay, config(), helpless).rows.size(),
      1u);
  one.status = {StatusCode::kNoCandidate, "nobody"};
  const auto untested =
      testVariants(one, "idm", only, false, Background::kReplay, config(), config().planners);
  EXPECT_EQ(untested.status, "NO_CANDIDATE");
  EXPECT_TRUE(untested.rows.empty());
}

TEST(TuningReport, ShowsValuesAndScores) {
  EXPECT_NE(describeValues({{"a.b", 1.0}}, {{"a.b", 2.5}}).find("| a.b | 1 | 2.5 |"),
            std::string::npos);
  EXPECT_EQ(scoresCsv(named({"default", "1"}), {score(0.5, 2.0), score(0.25, 3.0)}, 1),
            "variant,a.b,avoidable,collision,low,high,progress,best\n"
            "default,1.5,10,0.5000,0.0000,1.0000,2.000,0\n"
            "1,1.5,10,0.2500,0.0000,1.0000,3.000,1\n");
}

}  // namespace
}  // namespace forge
