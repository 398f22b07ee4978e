#include "collision_forge/study/scorecard_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>
#include <sstream>

#include "collision_forge/study_settings/study_config.h"
#include "study/test_windows.h"

namespace forge {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

const StudyConfig& shipped() {
  static const StudyConfig config = loadStudyConfig(COLLISION_FORGE_SOURCE_DIR "/config");
  return config;
}

ResultRow attackRow(const MotionWindow& window, const std::string& method, double on_lane,
                    double least_gap) {
  ResultRow row;
  row.scene = window.scene;
  row.type = CollisionType::kRearEnd;
  row.tta = 4.0;
  row.method = method;
  row.request.emplace().attack =
      AttackFigures{window.id, window.agent_class, window.size, {}, {}, least_gap, window};
  row.request->attack->road.on_lane = on_lane;
  row.request->attack->peaks.jerk =
      0.5 *
      peakLimits(window.agent_class, window.size, shipped().attack.verification.drivable).jerk;
  return row;
}

/// 60 attacks of "search", every third not wholly on its lane, one without an answer, and a row of
/// another method.
std::vector<ResultRow> sampleRows() {
  std::mt19937_64 generator(1);
  std::vector<ResultRow> rows;
  for (const MotionWindow& window : drawnWindows(20, 3, 0.0, generator)) {
    const std::size_t i = rows.size();
    rows.push_back(attackRow(window, "search", i % 3 == 0 ? 0.5 : 1.0, static_cast<double>(i)));
  }
  rows.push_back(attackRow(simpleWindow("a", 8.0, 0.0), "other", 0.0, 0.0));
  rows.push_back(rows.front());
  rows.back().request->attack.reset();
  return rows;
}

std::vector<RecordedMotion> sampleRecorded() {
  std::mt19937_64 generator(2);
  std::vector<RecordedMotion> recorded;
  for (const MotionWindow& window : drawnWindows(20, 10, 0.0, generator)) {
    recorded.push_back({window, {}, 3.0});
    recorded.back().road.on_lane = recorded.size() % 2 == 0 ? 1.0 : 0.0;
  }
  return recorded;
}

ScorecardReport sampleReport() {
  return reportScorecard(sampleRows(), {"search"}, sampleRecorded(), shipped());
}

/// The value of a line of the CSV; throws std::out_of_range for none.
double csvValue(const std::string& csv, const std::string& begin) {
  std::istringstream stream(csv);
  for (std::string line; std::getline(stream, line);) {
    if (line.rfind(begin + ",", 0) != 0) continue;
    std::istringstream rest(line.substr(begin.size() + 1));
    std::string count, value;
    std::getline(rest, count, ',');
    std::getline(rest, value, ',');
    return std::stod(value);
  }
  throw std::out_of_range(begin);
}

TEST(ScorecardReport, SharesStandBesideThoseOfRecordedVehicles) {
  const ScorecardReport report = sampleReport();
  const RateTable& wholly = report.shares.front();
  EXPECT_EQ(wholly.measure.name, "wholly_on_lane");
  EXPECT_THAT(wholly.methods, ElementsAre("search", "recorded"));
  EXPECT_EQ(wholly.rates[0].back().trials, 60);
  EXPECT_NEAR(wholly.rates[0].back().value, 2.0 / 3.0, 1e-9);
  EXPECT_EQ(wholly.rates[1].back().value, 0.5);
  EXPECT_NEAR(report.shares[1].rates[0].back().value, 2.0 / 3.0 + 0.5 / 3.0, 1e-9);
}

TEST(ScorecardReport, RecordedVehiclesAreOfNoType) {
  const ScorecardReport report = sampleReport();
  for (const RateTable& table : report.shares) {
    for (std::size_t group = 0; group + 1 < table.groups.size(); ++group) {
      EXPECT_EQ(table.rates.back()[group].trials, 0);
    }
    EXPECT_EQ(table.rates.back().back().trials, 200);
  }
}

TEST(ScorecardReport, QuantilesAreOfTheLimitsOfTheClass) {
  const ScorecardReport report = sampleReport();
  EXPECT_NEAR(csvValue(report.csv, "least_gap_quantile_50,search,all"), 29.5, 1e-6);
  EXPECT_NEAR(csvValue(report.csv, "least_gap_quantile_5,search,all"), 0.05 * 59.0, 1e-6);
  EXPECT_NEAR(csvValue(report.csv, "least_gap_quantile_50,recorded,all"), 3.0, 1e-6);
  EXPECT_NEAR(csvValue(report.csv, "peak_jerk_quantile_99,search,RE"), 0.5, 1e-6);
  EXPECT_THROW(csvValue(report.csv, "peak_jerk_quantile_99,recorded,all"), std::out_of_range);
  EXPECT_THROW(csvValue(report.csv, "least_gap_quantile_50,search,LC"), std::out_of_range);
  EXPECT_THAT(report.markdown, HasSubstr("| search | - | - | 3.0 / 29.5 |"));
}

TEST(ScorecardReport, ClassifiersAndDistancesAreThoseOfTheScorecard) {
  std::vector<MotionWindow> attacks, recorded;
  for (const ResultRow& row : sampleRows()) {
    if (row.method == "search" && row.request->attack)
      attacks.push_back(*row.request->attack->window);
  }
  for (const RecordedMotion& motion : sampleRecorded()) recorded.push_back(motion.window);
  const Scorecard card = scorecardOf(attacks, recorded, shipped().evaluation.scorecard);
  const ScorecardReport report = sampleReport();
  ASSERT_FALSE(card.classifiers.empty());
  EXPECT_NEAR(csvValue(report.csv, "area,search,all"), card.classifiers.front().test.larger(),
              1e-4);
  EXPECT_NEAR(csvValue(report.csv, "area_floor,search,all"),
              card.classifiers.front().larger_floor.mean, 1e-4);
  EXPECT_NEAR(csvValue(report.csv, "area,search,rear_end"), card.classifiers.front().test.larger(),
              1e-4);
  ASSERT_EQ(card.distances.front().quantity, MotionQuantity::kSpeed);
  EXPECT_NEAR(csvValue(report.csv, "speed wasserstein,search,all"),
              card.distances.front().distance.wasserstein, 1e-4);
  EXPECT_THAT(report.markdown, HasSubstr("search: 60 attacks, 60 windows"));
}

TEST(ScorecardReport, IsTheSameFromRowsThatWereWritten) {
  std::vector<ResultRow> written;
  for (const ResultRow& row : sampleRows()) {
    ResultRow named = row;
    named.name = "1";
    named.status = "OK";
    named.meets.assign(measuresOf(Protocol::kStrict).size(), true);
    written.push_back(*rowFromCsv(toCsv(named), Protocol::kStrict));
  }
  std::vector<ResultRow> again;
  for (const ResultRow& row : written) again.push_back(*rowFromCsv(toCsv(row), Protocol::kStrict));
  const auto one = reportScorecard(written, {"search"}, sampleRecorded(), shipped());
  const auto same = reportScorecard(again, {"search"}, sampleRecorded(), shipped());
  EXPECT_EQ(one.markdown, same.markdown);
  EXPECT_EQ(one.csv, same.csv);
}

TEST(ScorecardReport, OfNothingHasTablesWithoutTrials) {
  const ScorecardReport report = reportScorecard({}, {"search"}, {}, shipped());
  EXPECT_EQ(report.shares.front().rates[0].back().trials, 0);
  EXPECT_THAT(report.markdown, HasSubstr("search: 0 attacks"));
  EXPECT_THAT(report.markdown, Not(HasSubstr("Area under the curve")));
}

}  // namespace
}  // namespace forge
