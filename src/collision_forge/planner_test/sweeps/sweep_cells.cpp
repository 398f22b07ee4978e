#include "collision_forge/planner_test/sweeps/sweep_cells.h"

#include <algorithm>
#include <map>
#include <utility>

#include "collision_forge/attack/drivers/careful_drive.h"
#include "collision_forge/base/geometry/enum_words.h"
#include "collision_forge/planner_test/sweeps/sweep_parameters.h"
#include "collision_forge/planner_test/trials/planner_result_file.h"

namespace forge {
namespace {

constexpr const char* kFormat = "collision_forge/sweep";
constexpr int kVersion = 1;

constexpr EnumWord<SweepVerdict> kVerdictWords[] = {
    {SweepVerdict::kAvoided, "avoided"},    {SweepVerdict::kHit, "hit"},
    {SweepVerdict::kHitOther, "hit_other"}, {SweepVerdict::kFailed, "failed"},
    {SweepVerdict::kRejected, "rejected"},  {SweepVerdict::kMixed, "mixed"},
};

SweepVerdict verdictOf(const RolloutOutcome& outcome) {
  if (outcome.failure != PlannerFailure::kNone) return SweepVerdict::kFailed;
  if (!outcome.contact) return SweepVerdict::kAvoided;
  return outcome.contact->is_attacker ? SweepVerdict::kHit : SweepVerdict::kHitOther;
}

/// Writes a number in full precision, or a word.
void writeValue(JsonLineWriter& writer, const SweepParameter& parameter, double value) {
  if (parameter.words.empty()) {
    writer.number(parameter.name.c_str(), value);
  } else {
    writer.text(parameter.name.c_str(), parameter.text(value));
  }
}

}  // namespace

const char* toString(SweepVerdict verdict) { return wordOf(kVerdictWords, verdict); }

std::vector<SweepOutcome> outcomesOf(const SweepCell& cell) {
  std::vector<SweepOutcome> outcomes;
  if (!cell.result.isTested()) return outcomes;
  for (const PlannerRow& row : cell.result.rows) {
    const auto& contact = row.outcome.contact;
    outcomes.push_back(
        {rowName(row), false, verdictOf(row.outcome), contact ? contact->impact_speed : 0.0});
  }
  for (const CarefulDrive& drive : cell.result.careful_drivers) {
    outcomes.push_back(
        {drive.driver, true, drive.avoids ? SweepVerdict::kAvoided : SweepVerdict::kHit, 0.0});
  }
  return outcomes;
}

std::string statusCounts(const std::vector<SweepCell>& cells) {
  std::map<std::string, int> counts;
  for (const SweepCell& cell : cells) ++counts[cell.result.status];
  std::vector<std::pair<int, std::string>> sorted;
  for (const auto& [status, count] : counts) sorted.emplace_back(-count, status);
  std::sort(sorted.begin(), sorted.end());
  std::string text;
  for (const auto& [count, status] : sorted) {
    text += (text.empty() ? "" : ", ") + std::to_string(-count) + " " + status;
  }
  return text;
}

std::string sweepLine(const SweepLayout& layout, const SweepCell& cell, std::size_t index) {
  JsonLineWriter writer;
  writer.beginObject();
  writer.text("format", kFormat);
  writer.count("version", kVersion);
  writer.count("cell", index + 1);
  writer.flag("grid", layout.is_grid);
  writer.texts("parameters", layout.parameters);
  writer.texts("map", layout.y.empty() ? std::vector{layout.x} : std::vector{layout.x, layout.y});
  writer.beginObject("values");
  for (std::size_t i = 0; i < layout.parameters.size(); ++i) {
    writeValue(writer, sweepParameter(layout.parameters[i]), cell.values[i]);
  }
  writer.endObject();
  writer.beginObject("result");
  writePlannerResult(writer, cell.result);
  writer.endObject();
  writer.endObject();
  return writer.line();
}

std::string sweepCsv(const SweepLayout& layout, const std::vector<SweepCell>& cells) {
  std::string text = "cell";
  for (const std::string& name : layout.parameters) text += "," + name;
  text += ",careful_drivers," + plannerResultCsvHeader() + "\n";
  for (std::size_t i = 0; i < cells.size(); ++i) {
    std::string start = std::to_string(i + 1);
    for (std::size_t j = 0; j < layout.parameters.size(); ++j) {
      start += "," + sweepParameter(layout.parameters[j]).text(cells[i].values[j]);
    }
    start += "," + avoiders(cells[i].result.careful_drivers, " ") + ",";
    for (const std::string& row : plannerResultCsvRows(cells[i].result)) text += start + row + "\n";
  }
  return text;
}

}  // namespace forge
