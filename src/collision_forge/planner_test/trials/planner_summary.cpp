#include "collision_forge/planner_test/trials/planner_summary.h"

#include <algorithm>
#include <iomanip>
#include <set>
#include <sstream>

#include "collision_forge/base/scene/formatted.h"

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
        if (rowName(row.planner, row.attacker.policy) != name) continue;
        scenes.insert(result.scene);
        addRow(result, row, summary);
      }
    }
    summary.scenes = static_cast<int>(scenes.size());
    summaries.push_back(std::move(summary));
  }
  return summaries;
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
