#include "collision_forge/study/evaluation/request_report.h"

#include <set>
#include <string>

#include "collision_forge/study/evaluation/request_evaluation.h"
#include "collision_forge/study/evaluation/row_rates.h"

namespace forge {
namespace {

/// Returns the index of the measure of all conditions by full definitions.
std::size_t headline() {
  const auto& measures = measuresOf(Protocol::kStrict);
  std::size_t index = 0;
  while (measures.at(index).name != "full_definitions") ++index;
  return index;
}

RateTable tableOf(const std::vector<ResultRow>& rows, std::size_t index, const Measure& measure,
                  const EvaluationPlan& plan) {
  MethodTrials trials;
  for (const std::string& method : requestRowMethods(plan)) {
    trials.emplace_back(method, trialsOf(rows, method, index));
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

bool isHistorySearch(const EvaluationPlan& plan) {
  return plan.mode != Mode::kReplay && plan.is_seeded;
}

/// Returns the rates over the requests that replay mode solves with any seed.
RateTable givenReplayTable(const std::vector<ResultRow>& rows, const EvaluationPlan& plan) {
  std::set<std::string> met;
  for (const ResultRow& row : rows) {
    if (row.method == "replay" && row.meets[headline()]) met.insert(row.name);
  }
  std::vector<ResultRow> given;
  for (const ResultRow& row : rows) {
    if (met.count(row.name) > 0) given.push_back(row);
  }
  const std::string& title = measuresOf(Protocol::kStrict)[headline()].title;
  RateTable table = tableOf(
      given, headline(),
      {"full_definitions_given_replay", title + ", recall against replay mode", std::nullopt},
      plan);
  table.methods.pop_back();  // replay itself, whose recall is 100 %
  table.rates.pop_back();
  return table;
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
    if (isBaseline(method)) continue;
    trials.push_back({method + ", solved although the road does not allow it", {}});
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

}  // namespace

std::vector<RateTable> requestTables(const std::vector<ResultRow>& rows,
                                     const EvaluationPlan& plan) {
  std::vector<RateTable> tables;
  const std::vector<ResultRow> allowed = rowsThatRoadAllows(rows, true);
  const auto& measures = measuresOf(Protocol::kStrict);
  for (std::size_t index = 0; index < measures.size(); ++index) {
    if (measures[index].name.find("angle_bands") != std::string::npos) continue;
    tables.push_back(tableOf(rows, index, measures[index], plan));
    tables.push_back(tableOf(allowed, index, ofWhatRoadAllows(measures[index]), plan));
  }
  if (isHistorySearch(plan)) {
    tables.push_back(givenReplayTable(rows, plan));
    tables.push_back(givenReplayTable(allowed, plan));
    tables.back().measure = ofWhatRoadAllows(tables.back().measure);
  }
  tables.push_back(roadTable(rows, plan));
  if (plan.is_seeded) tables.push_back(solvedOffRoadTable(rows, plan));
  tables.push_back(believableTable(rows, plan));
  return tables;
}

std::optional<Calibration> requestCalibration(const std::vector<ResultRow>& rows,
                                              const EvaluationPlan& plan) {
  if (!isHistorySearch(plan)) return std::nullopt;
  std::vector<Prediction> promises;
  for (const ResultRow& row : rows) {
    if (row.method != plan.method || !row.confidence) continue;
    const double kept = row.meets[headline()] ? 1.0 : 0.0;
    promises.push_back({*row.confidence, {row.scene, row.type, row.tta, kept}});
  }
  return calibrate("full definitions", promises);
}

}  // namespace forge
