#include "collision_forge/planner_test/trials/planner_comparison.h"

#include <filesystem>
#include <fstream>
#include <map>
#include <stdexcept>
#include <utility>

#include "collision_forge/base/scene/formatted.h"
#include "collision_forge/planner_test/trials/planner_result_file.h"

namespace forge {
namespace {

using RowsByCase = std::map<std::string, const PlannerRow*>;

/// Returns the rows of a run by row name, then by case.
std::map<std::string, RowsByCase> rowsOf(const std::vector<PlannerTestResult>& results) {
  std::map<std::string, RowsByCase> found;
  for (const PlannerTestResult& result : results) {
    if (!result.isTested()) continue;
    for (const PlannerRow& row : result.rows) {
      found[rowName(row)][result.name] = &row;
    }
  }
  return found;
}

bool isFailed(const PlannerRow& row) { return row.outcome.failure != PlannerFailure::kNone; }

bool isHit(const PlannerRow& row) {
  return !isFailed(row) && row.outcome.contact && row.outcome.contact->is_attacker;
}

RowComparison compareRows(const std::vector<PlannerTestResult>& order, const RowsByCase& before,
                          const RowsByCase& after) {
  RowComparison found;
  for (const PlannerTestResult& result : order) {
    const auto first = before.find(result.name);
    const auto second = after.find(result.name);
    if (first == before.end() || second == after.end()) continue;
    const PlannerRow& old_row = *first->second;
    const PlannerRow& new_row = *second->second;
    ++found.cases;
    found.score_before += old_row.outcome.nuplan.total;
    found.score_after += new_row.outcome.nuplan.total;
    if (isHit(old_row) && isHit(new_row)) ++found.still_hit;
    if (!isHit(old_row) && isHit(new_row)) found.newly_hit.push_back(result.name);
    if (isHit(old_row) && !isHit(new_row)) found.newly_avoided.push_back(result.name);
    if (!isFailed(old_row) && isFailed(new_row)) found.newly_failed.push_back(result.name);
  }
  if (found.cases > 0) {
    found.score_before /= found.cases;
    found.score_after /= found.cases;
  }
  return found;
}

void addNames(std::string& text, const std::string& title, const std::vector<std::string>& names) {
  if (names.empty()) return;
  text += "\n" + title + ":\n";
  for (const std::string& name : names) text += "- " + name + "\n";
}

}  // namespace

std::vector<RowComparison> compareRuns(const std::vector<PlannerTestResult>& before,
                                       const std::vector<PlannerTestResult>& after) {
  const auto old_rows = rowsOf(before);
  const auto new_rows = rowsOf(after);
  std::vector<std::pair<std::string, std::string>> names;
  if (old_rows.size() == 1 && new_rows.size() == 1) {
    names.emplace_back(old_rows.begin()->first, new_rows.begin()->first);
  } else {
    for (const auto& entry : old_rows) {
      if (new_rows.count(entry.first) > 0) names.emplace_back(entry.first, entry.first);
    }
  }
  std::vector<RowComparison> found;
  for (const auto& [old_name, new_name] : names) {
    RowComparison row = compareRows(before, old_rows.at(old_name), new_rows.at(new_name));
    if (row.cases == 0) continue;
    row.before = old_name;
    row.after = new_name;
    found.push_back(std::move(row));
  }
  if (found.empty()) {
    throw std::invalid_argument("the two runs have no planner and case in common");
  }
  return found;
}

std::string comparisonText(const std::vector<RowComparison>& rows) {
  std::string text =
      "| planner | cases | newly hit | newly avoided | still hit | newly failed | score |\n"
      "|---|---|---|---|---|---|---|\n";
  const auto nameOf = [](const RowComparison& row) {
    return row.before == row.after ? row.before : row.before + " -> " + row.after;
  };
  for (const RowComparison& row : rows) {
    text += formatted("| %s | %d | %zu | %zu | %d | %zu | %.3f -> %.3f |\n", nameOf(row).c_str(),
                      row.cases, row.newly_hit.size(), row.newly_avoided.size(), row.still_hit,
                      row.newly_failed.size(), row.score_before, row.score_after);
  }
  for (const RowComparison& row : rows) {
    addNames(text, nameOf(row) + ", newly hit", row.newly_hit);
    addNames(text, nameOf(row) + ", newly avoided", row.newly_avoided);
    addNames(text, nameOf(row) + ", newly failed", row.newly_failed);
  }
  return text;
}

std::vector<PlannerTestResult> readResults(const std::string& path) {
  namespace fs = std::filesystem;
  const std::string file_path =
      fs::is_directory(path) ? fs::path(path) / "results.jsonl" : fs::path(path);
  std::ifstream file(file_path);
  if (!file) throw std::runtime_error(file_path + ": cannot be read");
  std::vector<PlannerTestResult> results;
  for (std::string line; std::getline(file, line);) {
    const std::string where = file_path + ":" + std::to_string(results.size() + 1);
    dropMotions(results.emplace_back(readPlannerResultLine(where, line)));
  }
  return results;
}

}  // namespace forge
