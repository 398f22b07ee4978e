#include "collision_forge/planner_test/report/coverage_page.h"

#include <algorithm>
#include <set>
#include <utility>

#include "collision_forge/base/scene/contact_conditions.h"

#include "collision_forge/base/scene/number_words.h"

namespace forge {
namespace {

constexpr const char* kHead =
    "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
    "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src "
    "'unsafe-inline'\">\n<title>Coverage of catalogues</title>\n<style>\n"
    "body { font: 14px/1.4 system-ui, sans-serif; color: #21262e; background: #f5f6f8; margin: "
    "1rem; }\n"
    "table { border-collapse: collapse; background: #fff; }\n"
    "th, td { border: 1px solid #d9dde3; padding: .15rem .5rem; text-align: right; }\n"
    "th:first-child, td:first-child, .reason { text-align: left; }\n"
    "thead th { background: #e9ecf0; position: sticky; top: 0; }\n"
    ".entry td { background: #eef2f7; font-weight: 600; text-align: left; }\n"
    ".generated td:first-child { border-left: 6px solid #2e9e5b; }\n"
    ".rejected td:first-child { border-left: 6px solid #d9a400; }\n"
    ".missing td:first-child { border-left: 6px solid #a3abb6; color: #5d6673; }\n"
    "</style></head><body>\n<h1>Coverage of catalogues</h1>\n"
    "<p>Green: generated; amber: requested without an attack; grey: not requested. Possible: "
    "requests "
    "that the road allows. Others: attacks of requests that do not name the cell but meet it. "
    "Planners: hits by the attacker (avoidable ones in brackets) / "
    "passed."
    "</p>\n";

std::string escaped(const std::string& text) {
  std::string safe;
  for (const char letter : text) {
    if (letter == '<') {
      safe += "&lt;";
    } else if (letter == '&') {
      safe += "&amp;";
    } else {
      safe += letter;
    }
  }
  return safe;
}

std::string cell(const std::string& text) { return "<td>" + text + "</td>"; }

/// Returns the rejections, the commonest first.
std::string reasonsOf(const CellCoverage& coverage) {
  std::vector<std::pair<std::size_t, std::string>> sorted;
  for (const auto& [code, count] : coverage.reasons) sorted.emplace_back(count, code);
  std::sort(sorted.rbegin(), sorted.rend());
  std::string text;
  for (const auto& [count, code] : sorted) {
    text += (text.empty() ? "" : ", ") + std::to_string(count) + " " + code;
  }
  return text;
}

bool isCovered(const CellCoverage& counts) { return counts.generated + counts.others > 0; }

std::string rowOf(const std::string& name, const CellCoverage* coverage,
                  const std::set<std::string>& planners) {
  static const CellCoverage kNone;
  const CellCoverage& counts = coverage ? *coverage : kNone;
  const char* state = !coverage ? "missing" : isCovered(counts) ? "generated" : "rejected";
  std::string row = std::string("<tr class=\"") + state + "\">" + cell(escaped(name)) +
                    cell(std::to_string(counts.requests)) + cell(std::to_string(counts.possible)) +
                    cell(std::to_string(counts.generated)) + cell(std::to_string(counts.others));
  for (const std::string& planner : planners) {
    const auto found = counts.planners.find(planner);
    if (found == counts.planners.end()) {
      row += cell("");
    } else {
      const PlannerCoverage& tests = found->second;
      row += cell(std::to_string(tests.hit) + " (" + std::to_string(tests.avoidable) + ") / " +
                  std::to_string(tests.passed));
    }
  }
  return row + "<td class=\"reason\">" +
         (counts.requests > 0 ? reasonsOf(counts) : std::string("no request")) + "</td></tr>\n";
}

std::string catalogueOf(const std::string& name) { return name.substr(0, name.find('/')); }

}  // namespace

Coverage::Coverage(std::vector<CatalogueEntry> catalogue) : catalogue_(std::move(catalogue)) {}

void Coverage::add(const Scenario& scenario, const std::string& name,
                   const std::optional<ContactConditions>& measured) {
  const SceneRequest& asked = scenario.asked;
  const StatusCode code = scenario.answer.status.code;
  if (code == StatusCode::kOk) {
    std::optional<ContactConditions> conditions = measured;
    if (!conditions && asksForConditions(asked.request)) {
      conditions = scenario.answer.report.conditions;
    }
    for (const CatalogueEntry& entry : catalogue_) {
      for (const CatalogueCell& one : entry.cells) {
        if (one.name == asked.name ||
            !isInstance(one.request, asked.request, scenario.answer, conditions)) {
          continue;
        }
        ++cells_[one.name].others;
        cells_of_case_[name].push_back(one.name);
      }
    }
  }
  if (asked.name.empty()) return;
  cells_of_case_[name].push_back(asked.name);
  CellCoverage& counts = cells_[asked.name];
  ++counts.requests;
  counts.possible += code != StatusCode::kRoadDoesNotAllow;
  counts.generated += code == StatusCode::kOk;
  if (code != StatusCode::kOk) ++counts.reasons[toString(code)];
}

void Coverage::add(const PlannerTestResult& result) {
  const auto known = cells_of_case_.find(result.name);
  if (known == cells_of_case_.end() || !result.isTested()) return;
  for (const std::string& name : known->second) {
    for (const PlannerRow& row : result.rows) {
      PlannerCoverage& tests = cells_[name].planners[rowName(row)];
      if (row.outcome.failure != PlannerFailure::kNone) continue;
      const bool is_hit = row.outcome.contact && row.outcome.contact->is_attacker;
      tests.hit += is_hit;
      tests.avoidable += is_hit && row.evasion && row.evasion->is_avoidable;
      tests.passed += !is_hit;
    }
  }
}

std::string Coverage::page() const {
  std::set<std::string> planners;
  std::set<std::string> catalogues;
  for (const auto& [name, counts] : cells_) {
    catalogues.insert(catalogueOf(name));
    for (const auto& [planner, tests] : counts.planners) planners.insert(planner);
  }
  std::string text = kHead;
  for (const std::string& shown : catalogues) {
    std::string rows;
    std::size_t all = 0;
    std::size_t generated = 0;
    for (const CatalogueEntry& entry : catalogue_) {
      if (catalogueOf(entry.name) != shown) continue;
      rows += "<tr class=\"entry\"><td colspan=\"" + std::to_string(6 + planners.size()) + "\">" +
              escaped(entry.name + ": " + entry.text) + "</td></tr>\n";
      if (!entry.missing.empty()) {
        rows += "<tr class=\"missing\"><td colspan=\"" + std::to_string(6 + planners.size()) +
                "\">cannot be requested: " + escaped(entry.missing) + "</td></tr>\n";
      }
      for (const CatalogueCell& one : entry.cells) {
        const auto found = cells_.find(one.name);
        const CellCoverage* counts = found != cells_.end() ? &found->second : nullptr;
        ++all;
        generated += counts && isCovered(*counts);
        rows += rowOf(one.name.substr(shown.size() + 1), counts, planners);
      }
    }
    text += "<h2>" + shown + ": " + std::to_string(generated) + " of " + counted(all, "cell") +
            " generated</h2>\n<table><thead><tr><th>cell</th><th>requests</th>"
            "<th>possible</th><th>generated</th><th>others</th>";
    for (const std::string& planner : planners) text += "<th>" + escaped(planner) + "</th>";
    text += "<th class=\"reason\">rejections</th></tr></thead>\n" + rows + "</table>\n";
  }
  return text + "</body></html>\n";
}

}  // namespace forge
