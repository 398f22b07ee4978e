#include "collision_forge/planner_test/trials/pass_criteria.h"

#include <algorithm>
#include <fstream>
#include <functional>
#include <sstream>
#include <stdexcept>

#include "collision_forge/attack/drivers/driver_models.h"
#include "collision_forge/base/scene/formatted.h"
#include "collision_forge/base/scene/number_words.h"

namespace forge {
namespace {

using Rows = std::vector<const PlannerRow*>;

bool isHit(const PlannerRow& row) {
  const RolloutOutcome& outcome = row.outcome;
  return outcome.failure == PlannerFailure::kNone && outcome.contact &&
         outcome.contact->is_attacker;
}

/// Returns true if the competent and careful driver of UN R157 avoids the attack on the planner's
/// path.
bool isCarefullyAvoided(const RolloutOutcome& outcome) {
  return std::any_of(outcome.careful_drivers.begin(), outcome.careful_drivers.end(),
                     [](const CarefulDrive& drive) {
                       return drive.driver == toString(DriverModel::kCcDriver) && drive.avoids;
                     });
}

/// A measure counts the rows for which `value` is 1, or is the mean, maximum or minimum of `value`.
struct Measure {
  enum class Kind { kCount, kMean, kMaximum, kMinimum };
  const char* name;
  const char* text;
  Kind kind;
  double (*value)(const PlannerRow&);
};

const Measure kMeasures[] = {
    {"hits", "cases in which the attacker hits the ego", Measure::Kind::kCount,
     [](const PlannerRow& row) { return isHit(row) ? 1.0 : 0.0; }},
    {"avoidable_hits", "hits that the planner could have avoided", Measure::Kind::kCount,
     [](const PlannerRow& row) { return isHit(row) && row.is_fair ? 1.0 : 0.0; }},
    {"careful_avoidable_hits", "hits that the competent and careful driver of UN R157 avoids",
     Measure::Kind::kCount,
     [](const PlannerRow& row) {
       return isHit(row) && isCarefullyAvoided(row.outcome) ? 1.0 : 0.0;
     }},
    {"at_fault_contacts", "first contacts with any agent at the fault of the ego",
     Measure::Kind::kCount,
     [](const PlannerRow& row) {
       return row.outcome.contact && row.outcome.contact->at_fault ? 1.0 : 0.0;
     }},
    {"failures", "cases that a failure of the planner ended", Measure::Kind::kCount,
     [](const PlannerRow& row) {
       return row.outcome.failure != PlannerFailure::kNone ? 1.0 : 0.0;
     }},
    {"impact_speed", "m/s, highest impact speed of a hit", Measure::Kind::kMaximum,
     [](const PlannerRow& row) { return isHit(row) ? row.outcome.contact->impact_speed : 0.0; }},
    {"delta_v", "m/s, highest delta-v of the ego in a hit", Measure::Kind::kMaximum,
     [](const PlannerRow& row) {
       return isHit(row) ? row.outcome.contact->severity.ego.delta_v : 0.0;
     }},
    {"mais3", "highest probability of MAIS 3+ of either party of a hit, 0 to 1",
     Measure::Kind::kMaximum,
     [](const PlannerRow& row) {
       return isHit(row) ? row.outcome.contact->severity.worse().mais3 : 0.0;
     }},
    {"iso_26262_class", "highest severity class of a hit, 0 to 3, by the strictest bounds",
     Measure::Kind::kMaximum,
     [](const PlannerRow& row) {
       if (!isHit(row)) return 0.0;
       const CrashSeverity& severity = row.outcome.contact->severity;
       return static_cast<double>(std::max(severity.ego.most_class, severity.other.most_class));
     }},
    {"braking", "m/s2, hardest braking of the ego", Measure::Kind::kMaximum,
     [](const PlannerRow& row) { return row.outcome.max_braking; }},
    {"score", "mean of nuPlan's closed-loop score, 0 to 1", Measure::Kind::kMean,
     [](const PlannerRow& row) { return row.outcome.nuplan.total; }},
    {"worst_score", "lowest of nuPlan's closed-loop score, 0 to 1", Measure::Kind::kMinimum,
     [](const PlannerRow& row) { return row.outcome.nuplan.total; }},
};

const Measure& measureOf(const std::string& name) {
  const auto found = std::find_if(std::begin(kMeasures), std::end(kMeasures),
                                  [&](const Measure& measure) { return name == measure.name; });
  if (found != std::end(kMeasures)) return *found;
  std::string known;
  for (const Measure& measure : kMeasures)
    known += std::string(known.empty() ? "" : ", ") + measure.name;
  throw std::invalid_argument("unknown measure \"" + name + "\"; known measures: " + known);
}

double valueOf(const Measure& measure, const Rows& rows) {
  if (rows.empty()) return 0.0;
  double sum = 0.0;
  double least = measure.value(*rows.front());
  double most = least;
  for (const PlannerRow* row : rows) {
    const double value = measure.value(*row);
    sum += value;
    least = std::min(least, value);
    most = std::max(most, value);
  }
  switch (measure.kind) {
    case Measure::Kind::kMean:
      return sum / static_cast<double>(rows.size());
    case Measure::Kind::kMaximum:
      return most;
    case Measure::Kind::kMinimum:
      return least;
    case Measure::Kind::kCount:
      break;
  }
  return sum;
}

bool holds(const Criterion& criterion, double value) {
  if (criterion.relation == ">") return value > criterion.bound;
  if (criterion.relation == ">=") return value >= criterion.bound;
  if (criterion.relation == "<") return value < criterion.bound;
  return value <= criterion.bound;
}

}  // namespace

std::vector<std::string> measureDescriptions() {
  std::vector<std::string> texts;
  for (const Measure& measure : kMeasures) {
    texts.push_back(std::string(measure.name) + ": " + measure.text);
  }
  return texts;
}

Criterion parseCriterion(const std::string& text) {
  Criterion criterion;
  criterion.text = text;
  const std::size_t begin = text.find_first_of("<>");
  const std::size_t end = text.find_first_not_of("<>=", begin);
  if (begin != std::string::npos && end != std::string::npos) {
    criterion.relation = text.substr(begin, end - begin);
    std::istringstream name(text.substr(0, begin));
    std::istringstream number(text.substr(end));
    std::string rest;
    const bool is_complete = (name >> criterion.measure) && !(name >> rest) &&
                             (number >> criterion.bound) && !(number >> rest);
    const std::string& relation = criterion.relation;
    const bool is_relation =
        relation == ">" || relation == ">=" || relation == "<" || relation == "<=";
    if (is_complete && is_relation) {
      measureOf(criterion.measure);
      return criterion;
    }
  }
  throw std::invalid_argument("\"" + text +
                              "\" is not a criterion such as avoidable_hits > 0 (relations: "
                              ">, >=, <, <=)");
}

std::vector<Criterion> parseCriteria(const std::string& text) {
  if (text.rfind('@', 0) != 0) return {parseCriterion(text)};
  const std::string path = text.substr(1);
  std::ifstream file(path);
  std::vector<Criterion> criteria;
  int number = 0;
  for (std::string line; std::getline(file, line);) {
    ++number;
    line = line.substr(0, line.find('#'));
    const std::size_t begin = line.find_first_not_of(" \t\r");
    if (begin == std::string::npos) continue;
    const std::size_t end = line.find_last_not_of(" \t\r");
    try {
      criteria.push_back(parseCriterion(line.substr(begin, end - begin + 1)));
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(path + ":" + std::to_string(number) + ": " + error.what());
    }
  }
  if (criteria.empty()) throw std::invalid_argument(path + ": cannot be read, or has no criterion");
  return criteria;
}

std::vector<CriterionVerdict> judge(const std::vector<Criterion>& criteria,
                                    const std::vector<PlannerTestResult>& results,
                                    const std::vector<std::string>& rows) {
  std::vector<CriterionVerdict> verdicts;
  for (const std::string& name : rows) {
    Rows found;
    for (const PlannerTestResult& result : results) {
      if (!result.isTested()) continue;
      for (const PlannerRow& row : result.rows) {
        if (rowName(row) == name) found.push_back(&row);
      }
    }
    for (const Criterion& criterion : criteria) {
      const double value = valueOf(measureOf(criterion.measure), found);
      verdicts.push_back({criterion, name, value, holds(criterion, value)});
    }
  }
  return verdicts;
}

std::string verdictText(const std::vector<CriterionVerdict>& verdicts) {
  std::string text;
  for (const CriterionVerdict& verdict : verdicts) {
    text += (verdict.is_failed ? "FAILED  " : "passed  ") + verdict.row + ": fails if " +
            verdict.criterion.text + "; " + verdict.criterion.measure + " = " +
            numberText(verdict.value) + "\n";
  }
  return text;
}

std::string failedBy(const std::vector<Criterion>& criteria, const PlannerRow& row) {
  for (const Criterion& criterion : criteria) {
    const Measure& measure = measureOf(criterion.measure);
    const double value = measure.value(row);
    const bool is_counted = measure.kind == Measure::Kind::kCount && value > 0.0;
    if (is_counted || (measure.kind != Measure::Kind::kCount && holds(criterion, value))) {
      return criterion.text;
    }
  }
  return "";
}

}  // namespace forge
