#include "collision_forge/study/evaluation/request_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

namespace forge {
namespace {

using testing::ElementsAre;

EvaluationPlan searchPlan() { return {Protocol::kStrict, "search", true, Mode::kHistory, 1}; }

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

/// Two requests: the first is met by everything, the second by nothing.
std::vector<ResultRow> sampleRows() {
  return {row("1", "constant_velocity", true, true),   row("1", "nominal", true, true),
          row("1", "search", true, true, 0.75),        row("1", "replay", true, true),
          row("2", "constant_velocity", false, false), row("2", "nominal", true, false),
          row("2", "search", false, false, 0.25),      row("2", "replay", false, false)};
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

TEST(RequestReport, RecallAgainstReplayCountsOnlyRequestsSolvedByReplay) {
  const auto tables = requestTables(sampleRows(), searchPlan());
  EXPECT_THAT(ratesOf(tableNamed(tables, "full_definitions")), ElementsAre(0.5, 0.5, 0.5, 0.5));
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
  EXPECT_THAT(namesOf(tables), testing::Each(testing::Not(testing::HasSubstr("angle_bands"))));
}

TEST(RequestReport, SolvedRequestsThatTheRoadDoesNotAllowHaveATable) {
  std::vector<ResultRow> rows = withRoad(sampleRows());
  rows[6].status = "ROAD_DOES_NOT_ALLOW";  // of search
  const auto tables = requestTables(rows, searchPlan());
  const RateTable& answered = tableNamed(tables, "answered_of_not_allowed");
  EXPECT_THAT(answered.methods, ElementsAre("search, solved although the road does not allow it",
                                            "replay, solved although the road does not allow it"));
  EXPECT_THAT(ratesOf(answered), ElementsAre(0.0, 1.0));
  EXPECT_EQ(answered.rates[0].back().trials, 1);
}

TEST(RequestReport, PlausibilityIsCountedAmongAttacksWithContact) {
  std::vector<ResultRow> rows = sampleRows();
  rows[0].request->believable = true;  // both of constant_velocity
  rows[4].request->believable = false;
  rows[1].request->believable = true;  // of nominal
  const auto tables = requestTables(rows, searchPlan());
  const RateTable& table = tableNamed(tables, "believable");
  EXPECT_EQ(table.rates[0].back().value, 0.5);
  EXPECT_EQ(table.rates[1].back().trials, 1);
  EXPECT_EQ(table.rates[2].back().trials, 0);
}

TEST(RequestReport, ARequestIsSolvedByReplayWithAnySeed) {
  std::vector<ResultRow> rows = sampleRows();
  ResultRow second = row("2", "replay", true, true);
  second.seed = 1;
  rows.push_back(second);
  const auto tables = requestTables(rows, searchPlan());
  const RateTable& full = tableNamed(tables, "full_definitions_given_replay");
  EXPECT_EQ(full.rates[0].back().trials, 2);
}

TEST(RequestReport, TheCalibrationCoversTheHistorySearch) {
  std::vector<ResultRow> rows = sampleRows();
  rows.push_back(row("3", "search", true, true));
  rows.back().confidence.reset();  // a search without an attack
  const auto calibration = requestCalibration(rows, searchPlan());
  ASSERT_TRUE(calibration);
  ASSERT_EQ(calibration->deciles.size(), 2u);
  EXPECT_EQ(calibration->deciles[0].mean_confidence, 0.25);
  EXPECT_EQ(calibration->deciles[0].kept.value, 0.0);
  EXPECT_EQ(calibration->deciles[1].mean_confidence, 0.75);
  EXPECT_EQ(calibration->deciles[1].kept.value, 1.0);
}

}  // namespace
}  // namespace forge
