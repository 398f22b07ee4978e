#include "collision_forge/study/evaluation/request_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

namespace forge {
namespace {

using testing::ElementsAre;

/// A plan with strict limits and without plausibility, which has both columns.
EvaluationPlan searchPlan(Mode mode = Mode::kHistory) {
  EvaluationPlan plan{Protocol::kStrict, "search", true, mode, 1};
  plan.limits = LimitSet::kStrict;
  plan.believable = false;
  return plan;
}

EvaluationPlan believablePlan() {
  EvaluationPlan plan = searchPlan();
  plan.limits = LimitSet::kDrivable;
  plan.believable = true;
  return plan;
}

/// A row that meets the angle bands, optionally also the full definitions, and then has contact.
ResultRow row(const std::string& name, const std::string& method, bool angle, bool full,
              double confidence = 0.5) {
  ResultRow row;
  row.name = name;
  row.scene = "scene-" + name;
  row.type = CollisionType::kLtap;
  row.tta = 2.0;
  row.method = method;
  row.meets = {angle, full, angle, angle, full, true, true, true};
  row.confidence = confidence;
  row.status = "OK";
  row.request.emplace();
  return row;
}

/// The road does not allow the second request.
std::vector<ResultRow> withRoad(std::vector<ResultRow> rows) {
  for (ResultRow& row : rows) row.request->road_allows = row.name == "1";
  return rows;
}

std::vector<std::string> namesOf(const std::vector<RateTable>& tables) {
  std::vector<std::string> names;
  for (const RateTable& table : tables) names.push_back(table.measure.name);
  return names;
}

/// Two requests: the first is met by everything, the second by searches in the angle bands that
/// they are for, in history only by seed 1 of those for the full definitions.
std::vector<ResultRow> sampleRows() {
  return {row("1", "constant_velocity", true, true),
          row("1", "nominal", true, true),
          row("1", "search_angle_bands", true, false, 0.75),
          row("1", "search_full_definitions", true, true),
          row("1", "replay_angle_bands", true, false),
          row("1", "replay_full_definitions", true, true),
          row("2", "constant_velocity", false, false),
          row("2", "nominal", true, false),
          row("2", "search_angle_bands", true, false, 0.25),
          row("2", "search_full_definitions", false, false),
          row("2", "replay_angle_bands", true, false),
          row("2", "replay_full_definitions", false, false)};
}

const RateTable& tableNamed(const std::vector<RateTable>& tables, const std::string& name) {
  for (const RateTable& table : tables) {
    if (table.measure.name == name) return table;
  }
  throw std::out_of_range(name);
}

/// Returns the rates of all groups by method, in the order of the table.
std::vector<double> ratesOf(const RateTable& table) {
  std::vector<double> rates;
  for (const auto& of_method : table.rates) rates.push_back(of_method.back().value);
  return rates;
}

TEST(RequestReport, SearchesCountOnlyInTheirColumn) {
  const auto tables = requestTables(sampleRows(), searchPlan());
  for (const char* name : {"angle_bands", "full_definitions", "type_angle_bands", "type_full"}) {
    EXPECT_THAT(tableNamed(tables, name).methods,
                ElementsAre("constant_velocity", "nominal", "search", "replay"));
  }
  EXPECT_THAT(ratesOf(tableNamed(tables, "angle_bands")), ElementsAre(0.5, 1.0, 1.0, 1.0));
  EXPECT_THAT(ratesOf(tableNamed(tables, "type_angle_bands")), ElementsAre(0.5, 1.0, 1.0, 1.0));
  EXPECT_THAT(ratesOf(tableNamed(tables, "full_definitions")), ElementsAre(0.5, 0.5, 0.5, 0.5));
  EXPECT_THAT(ratesOf(tableNamed(tables, "type_full")), ElementsAre(0.5, 0.5, 0.5, 0.5));
  EXPECT_THAT(
      tableNamed(tables, "on_time").methods,
      ElementsAre("constant_velocity", "nominal", "search_angle_bands", "search_full_definitions",
                  "replay_angle_bands", "replay_full_definitions"));
}

TEST(RequestReport, RecallAgainstReplayCountsOnlyRequestsSolvedByReplay) {
  const auto tables = requestTables(sampleRows(), searchPlan());
  const RateTable& angle = tableNamed(tables, "angle_bands_given_replay");
  EXPECT_EQ(angle.rates[0].back().trials, 2);
  const RateTable& full = tableNamed(tables, "full_definitions_given_replay");
  EXPECT_EQ(full.rates[0].back().trials, 1);
  EXPECT_THAT(ratesOf(full), ElementsAre(1.0, 1.0, 1.0));
  EXPECT_THAT(full.methods, ElementsAre("constant_velocity", "nominal", "search"));
}

TEST(RequestReport, FullDefinitionsHaveATableOfTheRequestsThatTheRoadAllows) {
  const auto tables = requestTables(withRoad(sampleRows()), searchPlan());
  for (const char* name : {"full_definitions", "type_full", "contact", "limits_kept"}) {
    EXPECT_EQ(tableNamed(tables, name).rates[0].back().trials, 2) << name;
    EXPECT_EQ(tableNamed(tables, std::string(name) + "_of_allowed").rates[0].back().trials, 1);
  }
  EXPECT_THAT(ratesOf(tableNamed(tables, "full_definitions_of_allowed")),
              ElementsAre(1.0, 1.0, 1.0, 1.0));
  EXPECT_EQ(tableNamed(tables, "full_definitions_given_replay_of_allowed").rates[0].back().trials,
            1);
  EXPECT_THAT(ratesOf(tableNamed(tables, "road_allows")), ElementsAre(0.5));
  EXPECT_EQ(tableNamed(tables, "road_allows").rates[0].back().trials, 2);
  EXPECT_THAT(namesOf(tables), testing::Not(testing::Contains("angle_bands_of_allowed")));
}

TEST(RequestReport, SolvedRequestsThatTheRoadDoesNotAllowHaveATable) {
  std::vector<ResultRow> rows = withRoad(sampleRows());
  rows[9].status = "ROAD_DOES_NOT_ALLOW";  // of search_full_definitions
  const auto tables = requestTables(rows, believablePlan());
  const RateTable& answered = tableNamed(tables, "answered_of_not_allowed");
  EXPECT_THAT(answered.methods,
              ElementsAre("search_full_definitions, answered though the road does not allow it",
                          "replay_full_definitions, answered though the road does not allow it"));
  EXPECT_THAT(ratesOf(answered), ElementsAre(0.0, 1.0));
  EXPECT_EQ(answered.rates[0].back().trials, 1);
}

TEST(RequestReport, PlausibilityIsCountedAmongAttacksWithContact) {
  std::vector<ResultRow> rows = sampleRows();
  rows[0].request->believable = true;  // both of constant_velocity
  rows[6].request->believable = false;
  rows[1].request->believable = true;  // of nominal
  const auto tables = requestTables(rows, believablePlan());
  const RateTable& table = tableNamed(tables, "believable");
  EXPECT_EQ(table.rates[0].back().value, 0.5);
  EXPECT_EQ(table.rates[1].back().trials, 1);
  EXPECT_EQ(table.rates[2].back().trials, 0);
}

TEST(RequestReport, ARequestIsSolvedByReplayWithAnySeed) {
  std::vector<ResultRow> rows = sampleRows();
  ResultRow second = row("2", "replay_full_definitions", true, true);
  second.seed = 1;
  rows.push_back(second);
  const auto tables = requestTables(rows, searchPlan());
  const RateTable& full = tableNamed(tables, "full_definitions_given_replay");
  EXPECT_EQ(full.rates[0].back().trials, 2);
}

TEST(RequestReport, OffRoadTableComparesTheAttackWithTheRecordedMotion) {
  std::vector<ResultRow> rows = sampleRows();
  rows[2].off_road_share = 0.5;  // of search_angle_bands
  rows[2].own_off_road_share = 0.125;
  rows[8].off_road_share = 0.25;
  rows[8].own_off_road_share = 0.375;
  rows[3].off_road_share = 0.75;  // whose attacker is not recorded to the contact
  const auto tables = requestTables(rows, searchPlan());
  const RateTable& angle = tableNamed(tables, "off_road_search_angle_bands");
  EXPECT_THAT(angle.methods, ElementsAre("attack", "own motion", "difference"));
  EXPECT_THAT(ratesOf(angle), ElementsAre(0.375, 0.25, 0.125));
  EXPECT_EQ(tableNamed(tables, "off_road_search_full_definitions").rates[0].back().trials, 0);
}

TEST(RequestReport, CalibrationsCoverTheHistorySearchesByColumn) {
  std::vector<ResultRow> rows = sampleRows();
  rows[9].confidence.reset();  // a search without an answer
  const auto calibrations = requestCalibrations(rows, searchPlan());
  ASSERT_EQ(calibrations.size(), 2u);
  ASSERT_EQ(calibrations[0].deciles.size(), 2u);
  EXPECT_EQ(calibrations[0].deciles[0].promised, 0.25);
  EXPECT_EQ(calibrations[0].deciles[0].kept.value, 1.0);
  EXPECT_EQ(calibrations[0].deciles[1].promised, 0.75);
  ASSERT_EQ(calibrations[1].deciles.size(), 1u);
  EXPECT_EQ(calibrations[1].deciles[0].promised, 0.5);
  EXPECT_EQ(calibrations[1].deciles[0].kept.value, 1.0);
}

}  // namespace
}  // namespace forge
