#include "collision_forge/planner_test/trials/planner_summary.h"

#include <algorithm>
#include <iomanip>
#include <set>
#include <sstream>

#include "collision_forge/base/scene/formatted.h"
#include "collision_forge/base/scene/number_words.h"

namespace forge {
namespace {

std::string decimals(double value, int count) { return formatted("%.*f", count, value); }

void addRow(const PlannerTestResult& result, const PlannerRow& row, PlannerSummary& summary) {
  ++summary.cases;
  if (row.outcome.failure != PlannerFailure::kNone) {
    ++summary.failures;
    return;
  }
  const auto& contact = row.outcome.contact;
  if (!contact || !contact->is_attacker) return;
  ++summary.hits;
  if (row.is_fair) ++summary.avoidable;
  if (!summary.worst || contact->impact_speed > summary.worst->speed) {
    summary.worst = PlannerSummary::Impact{contact->impact_speed, result.name};
  }
}

/// Returns a number for no contact, a hit by the attacker, another contact, and a failure.
int verdictOf(const RolloutOutcome& outcome) {
  if (outcome.failure != PlannerFailure::kNone) return 3;
  if (!outcome.contact) return 0;
  return outcome.contact->is_attacker ? 1 : 2;
}

std::string timeText(const PlannerSummary& summary,
                     const std::map<std::string, double>& milliseconds) {
  const auto found = milliseconds.find(summary.planner);
  return found == milliseconds.end() ? "-" : decimals(found->second, 2);
}

}  // namespace

std::vector<PlannerSummary> summarizePlanners(const std::vector<PlannerTestResult>& results,
                                              const std::vector<std::string>& rows) {
  std::vector<PlannerSummary> summaries;
  for (const std::string& name : rows) {
    PlannerSummary summary;
    summary.planner = name;
    std::set<std::string> scenes;
    for (const PlannerTestResult& result : results) {
      if (!result.isTested()) continue;
      for (const PlannerRow& row : result.rows) {
        if (rowName(row) != name) continue;
        scenes.insert(result.scene);
        addRow(result, row, summary);
      }
    }
    summary.scenes = static_cast<int>(scenes.size());
    summaries.push_back(std::move(summary));
  }
  return summaries;
}

std::string backgroundText(const std::vector<PlannerTestResult>& results, const TestPlan& plan) {
  if (plan.backgrounds.size() < 2) return "";
  std::size_t tested = 0;
  std::size_t dependent = 0;
  std::map<std::string, int> counts;
  for (const PlannerTestResult& result : results) {
    std::map<std::string, std::set<int>> verdicts;  // by row without its background
    for (const PlannerRow& row : result.rows) {
      verdicts[rowName(RowKey{row.planner, row.attacker.policy})].insert(verdictOf(row.outcome));
    }
    bool is_dependent = false;
    for (const auto& [name, found] : verdicts) {
      counts[name] += found.size() > 1 ? 1 : 0;
      is_dependent = is_dependent || found.size() > 1;
    }
    tested += result.isTested() ? 1 : 0;
    dependent += is_dependent ? 1 : 0;
  }
  std::string text;
  for (const auto& [name, count] : counts) {
    text += (text.empty() ? ": " : ", ") + name + " " + std::to_string(count);
  }
  return "the verdict depends on the background traffic in " + std::to_string(dependent) + " of " +
         counted(tested, "case") + text + "\n";
}

std::string summaryText(const std::vector<PlannerSummary>& summaries,
                        const std::map<std::string, double>& milliseconds) {
  std::size_t width = 7;  // length of the title "planner"
  for (const PlannerSummary& summary : summaries) width = std::max(width, summary.planner.size());
  std::ostringstream text;
  const auto begin = [&](const std::string& name) {
    text << std::left << std::setw(static_cast<int>(width)) << name << std::right;
  };
  begin("planner");
  text << "  scenes  cases  hit  avoidable  failed  ms a call  worst impact\n";
  for (const PlannerSummary& summary : summaries) {
    begin(summary.planner);
    text << std::setw(8) << summary.scenes << std::setw(7) << summary.cases << std::setw(5)
         << summary.hits << std::setw(11) << summary.avoidable << std::setw(8) << summary.failures
         << std::setw(11) << timeText(summary, milliseconds) << "  ";
    if (summary.worst) {
      text << decimals(summary.worst->speed, 1) << " m/s in " << summary.worst->case_name << '\n';
    } else {
      text << "-\n";
    }
  }
  return text.str();
}

}  // namespace forge
