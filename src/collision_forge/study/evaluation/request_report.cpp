#include "collision_forge/study/evaluation/request_report.h"

#include <array>
#include <set>
#include <string>

#include "collision_forge/study/evaluation/request_evaluation.h"
#include "collision_forge/study/evaluation/row_rates.h"

namespace forge {
namespace {

/// A column of the strict protocol.
struct Column {
  const char* title;
  const char* suffix;      ///< suffix of the row names of its methods
  std::size_t headline;    ///< index of the measure of all conditions
  std::size_t type;        ///< index of the measure of the type
  const char* given_name;  ///< name of the recall against replay mode
};

std::size_t measureAt(const std::string& name) {
  const auto& measures = measuresOf(Protocol::kStrict);
  std::size_t index = 0;
  while (measures.at(index).name != name) ++index;
  return index;
}

const std::array<Column, 2>& columns() {
  static const std::array<Column, 2> found = {
      {{"angle bands", "_angle_bands", measureAt("angle_bands"), measureAt("type_angle_bands"),
        "angle_bands_given_replay"},
       {"full definitions", "_full_definitions", measureAt("full_definitions"),
        measureAt("type_full"), "full_definitions_given_replay"}}};
  return found;
}

bool endsWith(const std::string& text, const std::string& end) {
  return text.size() >= end.size() &&
         text.compare(text.size() - end.size(), std::string::npos, end) == 0;
}

/// Returns the columns that the plan measures.
std::vector<Column> columnsOf(const EvaluationPlan& plan) {
  std::vector<Column> found(columns().begin(), columns().end());
  if (plan.believable) found.erase(found.begin());
  return found;
}

bool isOfAngleBands(std::size_t measure) {
  return measure == columns().front().headline || measure == columns().front().type;
}

const Column* columnOfMethod(const std::string& method) {
  for (const Column& column : columns()) {
    if (endsWith(method, column.suffix)) return &column;
  }
  return nullptr;
}

const Column* columnOfMeasure(std::size_t measure) {
  for (const Column& column : columns()) {
    if (measure == column.headline || measure == column.type) return &column;
  }
  return nullptr;
}

/// Returns the name of a method in the tables of a column, or "" if it does not belong there.
std::string nameIn(const Column* column, const std::string& method) {
  const Column* of_method = columnOfMethod(method);
  if (!column || !of_method) return method;
  return of_method == column ? method.substr(0, method.size() - std::string(column->suffix).size())
                             : "";
}

RateTable tableOf(const std::vector<ResultRow>& rows, std::size_t index, const Measure& measure,
                  const EvaluationPlan& plan) {
  MethodTrials trials;
  for (const std::string& method : requestRowMethods(plan)) {
    const std::string name = nameIn(columnOfMeasure(index), method);
    if (!name.empty()) trials.emplace_back(name, trialsOf(rows, method, index));
  }
  return tabulateTrials(measure, trials);
}

/// Returns the rows of the requests that the road allows (`allows`) or does not allow.
std::vector<ResultRow> rowsThatRoadAllows(const std::vector<ResultRow>& rows, bool allows) {
  std::vector<ResultRow> found;
  for (const ResultRow& row : rows) {
    if (row.request && row.request->road_allows == allows) found.push_back(row);
  }
  return found;
}

Measure ofWhatRoadAllows(Measure measure) {
  measure.name += "_of_allowed";
  measure.title += ", requests allowed by the road";
  return measure;
}

/// Returns the rows of the requests that replay mode solves with any seed.
std::vector<ResultRow> rowsThatReplayMeets(const std::vector<ResultRow>& rows,
                                           const Column& column) {
  const std::string replay = std::string("replay") + column.suffix;
  std::set<std::string> met;
  for (const ResultRow& row : rows) {
    if (row.method == replay && row.meets[column.headline]) met.insert(row.name);
  }
  std::vector<ResultRow> found;
  for (const ResultRow& row : rows) {
    if (met.count(row.name) > 0) found.push_back(row);
  }
  return found;
}

bool isHistorySearch(const EvaluationPlan& plan) {
  return plan.mode != Mode::kReplay && plan.is_seeded;
}

Measure givenReplay(const Column& column) {
  const std::string& title = measuresOf(Protocol::kStrict)[column.headline].title;
  return {column.given_name, title + ", recall against replay mode", std::nullopt};
}

RateTable givenReplayTable(const std::vector<ResultRow>& rows, const Column& column,
                           const EvaluationPlan& plan) {
  RateTable table =
      tableOf(rowsThatReplayMeets(rows, column), column.headline, givenReplay(column), plan);
  table.methods.pop_back();  // replay itself, whose recall is 100 %
  table.rates.pop_back();
  return table;
}

RateTable offRoadTable(const std::vector<ResultRow>& rows, const std::string& method) {
  MethodTrials trials = {{"attack", {}}, {"own motion", {}}, {"difference", {}}};
  for (const ResultRow& row : rows) {
    if (row.method != method || !row.own_off_road_share) continue;
    const double attack = *row.off_road_share;
    const double own = *row.own_off_road_share;
    trials[0].second.push_back({row.scene, row.type, row.tta, attack});
    trials[1].second.push_back({row.scene, row.type, row.tta, own});
    trials[2].second.push_back({row.scene, row.type, row.tta, attack - own});
  }
  const std::string title = "Off the drivable area up to contact, mean share of the box: ";
  return tabulateTrials({"off_road_" + method, title + method, std::nullopt}, trials);
}

/// Returns the share of requests that the road allows.
RateTable roadTable(const std::vector<ResultRow>& rows, const EvaluationPlan& plan) {
  const std::string each = requestRowMethods(plan).front();  // has one row per request
  std::vector<Trial> trials;
  for (const ResultRow& row : rows) {
    if (row.method != each || !row.request || !row.request->road_allows) continue;
    trials.push_back({row.scene, row.type, row.tta, *row.request->road_allows ? 1.0 : 0.0});
  }
  return tabulateTrials({"road_allows", "Allowed by the road", std::nullopt},
                        {{"requests", trials}});
}

/// Returns the share of solved requests among those that the road does not allow.
RateTable solvedOffRoadTable(const std::vector<ResultRow>& rows, const EvaluationPlan& plan) {
  MethodTrials trials;
  for (const std::string& method : requestRowMethods(plan)) {
    if (columnOfMethod(method) == nullptr) continue;
    trials.push_back({method + ", answered though the road does not allow it", {}});
    for (const ResultRow& row : rowsThatRoadAllows(rows, false)) {
      if (row.method != method) continue;
      const double answered = row.status == toString(StatusCode::kOk) ? 1.0 : 0.0;
      trials.back().second.push_back({row.scene, row.type, row.tta, answered});
    }
  }
  return tabulateTrials(
      {"answered_of_not_allowed", "Solved, requests not allowed by the road", std::nullopt},
      trials);
}

/// Returns the share of plausible attacks among those that touch the recorded ego.
RateTable believableTable(const std::vector<ResultRow>& rows, const EvaluationPlan& plan) {
  MethodTrials trials;
  for (const std::string& method : requestRowMethods(plan)) {
    trials.push_back({method, {}});
    for (const ResultRow& row : rows) {
      if (row.method != method || !row.request || !row.request->believable) continue;
      const double believable = *row.request->believable ? 1.0 : 0.0;
      trials.back().second.push_back({row.scene, row.type, row.tta, believable});
    }
  }
  return tabulateTrials(
      {"believable", "Plausible, of the attacks that touch the ego", std::nullopt}, trials);
}

/// Returns one table per measure, followed by the same over the requests that the road allows.
std::vector<RateTable> measureTables(const std::vector<ResultRow>& rows,
                                     const EvaluationPlan& plan) {
  std::vector<RateTable> tables;
  const std::vector<ResultRow> allowed = rowsThatRoadAllows(rows, true);
  const auto& measures = measuresOf(Protocol::kStrict);
  for (std::size_t index = 0; index < measures.size(); ++index) {
    if (isOfAngleBands(index)) {
      if (!plan.believable) tables.push_back(tableOf(rows, index, measures[index], plan));
      continue;
    }
    tables.push_back(tableOf(rows, index, measures[index], plan));
    tables.push_back(tableOf(allowed, index, ofWhatRoadAllows(measures[index]), plan));
  }
  return tables;
}

}  // namespace

std::vector<RateTable> requestTables(const std::vector<ResultRow>& rows,
                                     const EvaluationPlan& plan) {
  std::vector<RateTable> tables = measureTables(rows, plan);
  if (isHistorySearch(plan)) {
    for (const Column& column : columnsOf(plan)) {
      tables.push_back(givenReplayTable(rows, column, plan));
    }
    RateTable table = givenReplayTable(rowsThatRoadAllows(rows, true), columns().back(), plan);
    table.measure = ofWhatRoadAllows(table.measure);
    tables.push_back(std::move(table));
  }
  tables.push_back(roadTable(rows, plan));
  if (plan.is_seeded) tables.push_back(solvedOffRoadTable(rows, plan));
  tables.push_back(believableTable(rows, plan));
  for (const std::string& method : requestRowMethods(plan)) {
    tables.push_back(offRoadTable(rows, method));
  }
  return tables;
}

std::vector<Calibration> requestCalibrations(const std::vector<ResultRow>& rows,
                                             const EvaluationPlan& plan) {
  std::vector<Calibration> calibrations;
  if (!isHistorySearch(plan)) return calibrations;
  for (const Column& column : columnsOf(plan)) {
    std::vector<Promise> promises;
    for (const ResultRow& row : rows) {
      if (row.method != plan.method + column.suffix || !row.confidence) continue;
      const double kept = row.meets[column.headline] ? 1.0 : 0.0;
      promises.push_back({*row.confidence, {row.scene, row.type, row.tta, kept}});
    }
    calibrations.push_back(calibrate(column.title, promises));
  }
  return calibrations;
}

}  // namespace forge
