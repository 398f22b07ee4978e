#include "collision_forge/trials/planner_result.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "attack/test_scenes.h"
#include "collision_forge/data/json_line.h"
#include "data/collide_fixture.h"

namespace forge {
namespace {

const Config& config() {
  static const Config loaded = loadConfig(COLLISION_FORGE_SOURCE_DIR "/config");
  return loaded;
}

/// The attacker comes from behind at twice the ego's speed.
PlannerCase rearEnd() {
  const CollideClip clip =
      straightClip(CollisionType::kRearEnd, 0.0, 11, 5.0, {-14.7, 0.0, 0.0}, 10.0);
  PlannerCase one =
      caseOfClip(clip, ClipAttacker::kRecorded, std::make_shared<const LaneIndex>(twoLaneRoad()),
                 MethodMaker("search", builtInMethods(), config().attack, {}), config());
  one.source = "recorded";
  return one;
}

PlannerTestResult tested() {
  return testPlanners(rearEnd(), {"idm", "idm_published"}, Background::kReplay, config(),
                      config().planners);
}

TEST(PlannerResult, EveryPlannerHasARow) {
  const PlannerTestResult result = tested();
  EXPECT_EQ(result.status, "OK");
  EXPECT_TRUE(result.is_strict);
  EXPECT_TRUE(result.avoidability.is_avoidable);
  ASSERT_EQ(result.rows.size(), 2u);
  EXPECT_EQ(result.rows[0].planner, "idm");
  // IDM accelerates by at most 1 m/s2 and knows nothing of who comes from behind.
  ASSERT_TRUE(result.rows[0].outcome.contact);
  EXPECT_TRUE(result.rows[0].outcome.contact->is_attacker);
  EXPECT_FALSE(result.rows[0].outcome.contact->at_fault);
  EXPECT_EQ(result.rows[0].published_hit, true);
}

TEST(PlannerResult, ACaseWithoutAnAttackIsNotTested) {
  PlannerCase one = rearEnd();
  one.status = {StatusCode::kNoCandidate, "nobody"};
  const PlannerTestResult result =
      testPlanners(one, {"idm"}, Background::kReplay, config(), config().planners);
  EXPECT_EQ(result.status, "NO_CANDIDATE");
  EXPECT_EQ(result.message, "nobody");
  EXPECT_FALSE(result.isTested());
  EXPECT_TRUE(result.rows.empty());
}

TEST(PlannerResult, AnAttackerThatTouchesTheEgoAlreadyIsUnfit) {
  PlannerCase one = rearEnd();
  one.scenario.attacker.points.front().pose = {-3.0, 0.0, 0.0};
  const PlannerTestResult result =
      testPlanners(one, {"idm"}, Background::kReplay, config(), config().planners);
  EXPECT_EQ(result.status, "UNFIT");
  EXPECT_NE(result.message.find("touches the ego"), std::string::npos);
}

TEST(PlannerResult, OfAnUnfitClipThePublishedHitOfThePublishedIdmIsKnown) {
  PlannerCase one = rearEnd();
  one.scenario.attacker.points.front().pose = {-3.0, 0.0, 0.0};
  one.clip = straightClip(CollisionType::kRearEnd, 0.0, 12, 8.0, {-3.0, 0.0, 0.0}, 8.0);
  const PlannerTestResult result =
      testPlanners(one, {"idm", "idm_published"}, Background::kReplay, config(), config().planners);
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

TEST(PlannerResult, ALineReadsBackAsTheSameLine) {
  PlannerTestResult result = tested();
  result.rows[1].outcome.failure = PlannerFailure::kNotFinite;
  result.rows[1].outcome.failure_message = "point 3 is not finite";
  result.rows[1].outcome.contact.reset();
  result.rows[1].published_hit.reset();
  const std::string line = plannerResultLine(result);
  const PlannerTestResult read = readPlannerResultLine("here", line);
  EXPECT_EQ(read.rows.size(), 2u);
  EXPECT_EQ(read.rows[0].outcome.contact->impact_speed,
            result.rows[0].outcome.contact->impact_speed);
  EXPECT_EQ(read.rows[1].outcome.failure, PlannerFailure::kNotFinite);
  EXPECT_EQ(read.avoidability.from_now, result.avoidability.from_now);
  EXPECT_EQ(read.avoidability.last, result.avoidability.last);
  EXPECT_EQ(plannerResultLine(read), line);
}

TEST(PlannerResult, OfACaseThatCannotBeReadOnlyTheNameIsKnown) {
  PlannerCase nothing;
  nothing.name = "crashes:3";
  const PlannerTestResult result = untested(nothing, kUnreadable, "no scenario");
  const std::string line = plannerResultLine(result);
  EXPECT_NE(line.find(R"("name":"crashes:3","source":null,"scene":null,"type":null,"tta":null,)"
                      R"("now":null,"status":"UNREADABLE","message":"no scenario")"),
            std::string::npos)
      << line;
  EXPECT_EQ(plannerResultLine(readPlannerResultLine("here", line)), line);
  EXPECT_EQ(plannerResultCsvRows(result).front().find("crashes:3,,,,,UNREADABLE,"), 0u);
  std::string invented = line;
  invented.replace(invented.find("\"tta\":null"), 10, "\"tta\":4");
  EXPECT_THROW(readPlannerResultLine("here", invented), JsonLineError);
}

TEST(PlannerResult, AnotherFormatIsRefusedByField) {
  std::string line = plannerResultLine(tested());
  line.replace(line.find("\"version\":2"), 11, "\"version\":3");
  try {
    readPlannerResultLine("results.jsonl: line 4", line);
    ADD_FAILURE();
  } catch (const JsonLineError& error) {
    EXPECT_NE(std::string(error.what()).find("line 4"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("version"), std::string::npos);
  }
}

TEST(PlannerResult, CsvRowsHaveTheColumnsOfTheHeader) {
  const auto commas = [](const std::string& text) {
    return std::count(text.begin(), text.end(), ',');
  };
  PlannerTestResult result = tested();
  result.rows[1].outcome.contact.reset();
  const auto rows = plannerResultCsvRows(result);
  ASSERT_EQ(rows.size(), 2u);
  const auto expected = commas(plannerResultCsvHeader());
  for (const std::string& row : rows) EXPECT_EQ(commas(row), expected) << row;
  const auto unfit = plannerResultCsvRows(untested(rearEnd(), "UNFIT", "why"));
  ASSERT_EQ(unfit.size(), 1u);
  EXPECT_EQ(commas(unfit[0]), expected);
  EXPECT_EQ(commas(plannerResultCsvRows(untested({}, kUnreadable, "why"))[0]), expected);
}

}  // namespace
}  // namespace forge
