#include "collision_forge/planner_test/trials/planner_report.h"

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "collision_forge/attack/drivers/careful_drive.h"
#include "collision_forge/base/scene/number_words.h"

namespace forge {
namespace {

constexpr TableUnit kShare{};
constexpr double kSoft = 0.5;  // m/s; a softer contact is harmless

using ValueOf = std::function<std::optional<double>(const PlannerTestResult&, const PlannerRow&)>;

/// A measure of a rollout; its value is empty if the rollout does not count.
struct RolloutMeasure {
  Measure measure;
  TableUnit unit;
  ValueOf value;
  bool counts_unfit = false;  ///< rows of unfit clips are trials, too
};

bool hasFailed(const RolloutOutcome& outcome) { return outcome.failure != PlannerFailure::kNone; }

bool hitsAttacker(const RolloutOutcome& outcome) {
  return outcome.contact && outcome.contact->is_attacker;
}

/// Returns 1 if the condition holds; counts rollouts without a failure in the selected cases.
ValueOf shareOf(const std::function<bool(const PlannerTestResult&)>& is_wanted,
                const std::function<bool(const RolloutOutcome&)>& is_met) {
  return [=](const PlannerTestResult& result, const PlannerRow& row) -> std::optional<double> {
    if (hasFailed(row.outcome) || !is_wanted(result)) return std::nullopt;
    return is_met(row.outcome) ? 1.0 : 0.0;
  };
}

bool isAny(const PlannerTestResult&) { return true; }
bool isAvoidable(const PlannerTestResult& result) { return result.avoidability.is_avoidable; }
bool isStrict(const PlannerTestResult& result) { return result.is_strict; }
bool isStrictAvoidable(const PlannerTestResult& result) {
  return isStrict(result) && isAvoidable(result);
}

/// Returns the value of collisions with the attacker.
ValueOf ofHits(const std::function<double(const RolloutOutcome&)>& value) {
  return [=](const PlannerTestResult&, const PlannerRow& row) -> std::optional<double> {
    if (hasFailed(row.outcome) || !hitsAttacker(row.outcome)) return std::nullopt;
    return value(row.outcome);
  };
}

/// Returns 1 for a hit that the driver model avoids in the planner's place.
ValueOf avoidedBy(DriverModel model) {
  return ofHits([=](const RolloutOutcome& outcome) {
    return isAvoidedBy(outcome.careful_drivers, model) ? 1.0 : 0.0;
  });
}

/// Returns 1 if the condition holds; counts rollouts without a failure.
ValueOf ofAttackers(const std::function<bool(const AttackerSummary&)>& is_met) {
  return [=](const PlannerTestResult&, const PlannerRow& row) -> std::optional<double> {
    if (hasFailed(row.outcome)) return std::nullopt;
    return is_met(row.attacker) ? 1.0 : 0.0;
  };
}

/// Leaves out unfair hits, which do not characterise the planner.
std::optional<double> fairCollision(const PlannerTestResult&, const PlannerRow& row) {
  if (hasFailed(row.outcome) || !row.is_fair) return std::nullopt;
  return hitsAttacker(row.outcome) ? 1.0 : 0.0;
}

std::optional<double> canEvade(const PlannerTestResult&, const PlannerRow& row) {
  if (hasFailed(row.outcome) || !row.evasion) return std::nullopt;
  return row.evasion->is_avoidable ? 1.0 : 0.0;
}

std::optional<double> publishedHit(const PlannerTestResult&, const PlannerRow& row) {
  if (!row.published_hit) return std::nullopt;
  return *row.published_hit ? 1.0 : 0.0;
}

std::optional<double> offRoad(const PlannerTestResult&, const PlannerRow& row) {
  if (hasFailed(row.outcome)) return std::nullopt;
  return row.outcome.off_road_share;
}

std::optional<double> progress(const PlannerTestResult&, const PlannerRow& row) {
  const RolloutOutcome& outcome = row.outcome;
  constexpr double kStanding = 1.0;  // m; less progress gives no meaningful ratio
  if (hasFailed(outcome) || outcome.recorded_progress < kStanding) return std::nullopt;
  return outcome.progress / outcome.recorded_progress;
}

/// Adds the mean of each term of nuPlan's score.
std::vector<RolloutMeasure> nuplanMeasures() {
  std::vector<RolloutMeasure> measures;
  for (const NuplanPart& part : nuplanParts()) {
    std::string title = std::string("nuPlan's ") + part.name + ", mean";
    std::replace(title.begin(), title.end(), '_', ' ');
    measures.push_back(
        {{std::string("nuplan_") + part.name, title, {}},
         kShare,
         [part](const PlannerTestResult&, const PlannerRow& row) -> std::optional<double> {
           if (hasFailed(row.outcome)) return std::nullopt;
           return row.outcome.nuplan.*part.value;
         }});
  }
  return measures;
}

std::vector<RolloutMeasure> rolloutMeasures() {
  const auto collides = [](const RolloutOutcome& outcome) { return hitsAttacker(outcome); };
  std::vector<RolloutMeasure> measures = {
      {{"collision", "Collisions with the attacker", {}}, kShare, shareOf(isAny, collides)},
      {{"collision_avoidable", "Collisions with the attacker, of avoidable crashes", {}},
       kShare,
       shareOf(isAvoidable, collides)},
      {{"collision_strict", "Collisions with the attacker, of strict crashes", {}},
       kShare,
       shareOf(isStrict, collides)},
      {{"collision_strict_avoidable",
        "Collisions with the attacker, of strict and avoidable crashes",
        {}},
       kShare,
       shareOf(isStrictAvoidable, collides)},
      {{"collision_fair", "Collisions with the attacker, unfair ones excluded", {}},
       kShare,
       fairCollision},
      {{"evasion", "Avoidable collisions, share of collisions with the attacker", {}},
       kShare,
       canEvade},
      {{"as_asked", "Collisions with the attacker of the requested type at the requested time", {}},
       kShare,
       ofAttackers([](const AttackerSummary& attacker) { return attacker.as_asked; })},
      {{"gave_up", "Attackers that aborted or finished before the end", {}},
       kShare,
       ofAttackers([](const AttackerSummary& attacker) {
         return attacker.phase == AttackerPhase::kDrivingOn;
       })},
      {{"attacker_limits", "Attackers that violated one of their limits", {}},
       kShare,
       ofAttackers([](const AttackerSummary& attacker) { return !attacker.broken_limit.empty(); })},
      {{"attacker_touched", "Attackers that touched another agent that does not react", {}},
       kShare,
       ofAttackers([](const AttackerSummary& attacker) { return !attacker.touched.empty(); })},
      {{"published_hit", "Collisions with the attacker by the published protocol", {}},
       kShare,
       publishedHit,
       true},
      {{"at_fault", "First contacts with any agent, planner at fault", {}},
       kShare,
       shareOf(isAny, [](const RolloutOutcome& o) { return o.contact && o.contact->at_fault; })},
      {{"other", "First contacts with an agent other than the attacker", {}},
       kShare,
       shareOf(isAny, [](const RolloutOutcome& o) { return o.contact && !hitsAttacker(o); })},
      {{"impact_speed", "Impact speed of collisions with the attacker, mean", {}},
       {"m/s", 1.0},
       ofHits([](const RolloutOutcome& o) { return o.contact->impact_speed; })},
      {{"delta_v", "Delta-v of the ego in collisions with the attacker, mean", {}},
       {"m/s", 1.0},
       ofHits([](const RolloutOutcome& o) { return o.contact->severity.ego.delta_v; })},
      {{"mais3", "Probability of an injury of MAIS 3+ in collisions with the attacker, mean", {}},
       kShare,
       ofHits([](const RolloutOutcome& o) { return o.contact->severity.worse().mais3; })},
      {{"soft", "Collisions below 0.5 m/s, share of collisions with the attacker", {}},
       kShare,
       ofHits([](const RolloutOutcome& o) { return o.contact->impact_speed < kSoft ? 1.0 : 0.0; })},
      {{"collision_at_fault",
        "Collisions with the planner at fault, share of collisions with the attacker",
        {}},
       kShare,
       ofHits([](const RolloutOutcome& o) { return o.contact->at_fault ? 1.0 : 0.0; })},
      {{"hard_braking", "Rollouts with hard braking", {}},
       kShare,
       shareOf(isAny, [](const RolloutOutcome& outcome) { return outcome.hard_braking > 0.0; })},
      {{"off_road", "Share of the ego's box off the drivable area, mean", {}}, kShare, offRoad},
      {{"progress", "Progress along the route, share of the recorded ego's, mean", {}},
       kShare,
       progress},
      {{"failure", "Rollouts that ended with a planner failure", {}},
       kShare,
       [](const PlannerTestResult&, const PlannerRow& row) -> std::optional<double> {
         return hasFailed(row.outcome) ? 1.0 : 0.0;
       }},
  };
  for (const DriverModel model : kDriverModels) {
    measures.push_back({{std::string("avoided_by_") + toString(model),
                         std::string("Collisions with the attacker that ") + toString(model) +
                             " avoids, share of collisions with the attacker",
                         {}},
                        kShare,
                        avoidedBy(model)});
  }
  for (RolloutMeasure& measure : nuplanMeasures()) measures.push_back(std::move(measure));
  return measures;
}

/// Returns the sources in order of appearance; unreadable cases have none.
std::vector<std::string> sourcesOf(const std::vector<PlannerTestResult>& results) {
  std::vector<std::string> sources;
  for (const PlannerTestResult& result : results) {
    if (result.isRead() &&
        std::find(sources.begin(), sources.end(), result.source) == sources.end()) {
      sources.push_back(result.source);
    }
  }
  return sources;
}

Trial trialOf(const PlannerTestResult& result, double value) {
  return {result.scene, result.type, result.tta, value};
}

PlannerTable rolloutTable(const RolloutMeasure& measure,
                          const std::vector<PlannerTestResult>& results,
                          const std::vector<std::string>& planners) {
  const std::vector<std::string> sources = sourcesOf(results);
  MethodTrials trials;
  for (const std::string& planner : planners) {
    for (const std::string& source : sources) {
      trials.emplace_back(sources.size() > 1 ? planner + " / " + source : planner,
                          std::vector<Trial>());
      for (const PlannerTestResult& result : results) {
        if (!(result.isTested() || measure.counts_unfit) || result.source != source) continue;
        for (const PlannerRow& row : result.rows) {
          if (rowName(row) != planner) continue;
          const auto value = measure.value(result, row);
          if (value) trials.back().second.push_back(trialOf(result, *value));
        }
      }
    }
  }
  return {tabulateTrials(measure.measure, trials), measure.unit};
}

using IsMet = std::function<bool(const PlannerTestResult&)>;

/// Returns the share of tested cases that meet each condition, one row per source and condition.
PlannerTable caseTable(const Measure& measure,
                       const std::vector<std::pair<std::string, IsMet>>& conditions,
                       const IsMet& is_wanted, const std::vector<PlannerTestResult>& results) {
  const std::vector<std::string> sources = sourcesOf(results);
  MethodTrials trials;
  for (const auto& [name, is_met] : conditions) {
    for (const std::string& source : sources) {
      trials.emplace_back(sources.size() > 1 ? name + " / " + source : name, std::vector<Trial>());
      for (const PlannerTestResult& result : results) {
        if (!result.isTested() || result.source != source || !is_wanted(result)) continue;
        trials.back().second.push_back(trialOf(result, is_met(result) ? 1.0 : 0.0));
      }
    }
  }
  return {tabulateTrials(measure, trials), kShare};
}

std::vector<PlannerTable> avoidabilityTables(const std::vector<PlannerTestResult>& results) {
  const auto worksFromNow = [](EvasiveManoeuvre manoeuvre) -> IsMet {
    return [=](const PlannerTestResult& result) {
      const auto& found = result.avoidability.from_now;
      return std::find(found.begin(), found.end(), manoeuvre) != found.end();
    };
  };
  std::vector<std::pair<std::string, IsMet>> manoeuvres;
  for (const EvasiveManoeuvre manoeuvre :
       {EvasiveManoeuvre::kKeeping, EvasiveManoeuvre::kBraking, EvasiveManoeuvre::kAccelerating,
        EvasiveManoeuvre::kSteering, EvasiveManoeuvre::kBoth}) {
    manoeuvres.emplace_back(toString(manoeuvre), worksFromNow(manoeuvre));
  }
  std::vector<std::pair<std::string, IsMet>> drivers;
  for (const DriverModel model : kDriverModels) {
    drivers.emplace_back(toString(model), [model](const PlannerTestResult& result) {
      return isAvoidedBy(result.careful_drivers, model);
    });
  }
  return {
      caseTable({"strict", "Crashes that meet the strict protocol", {}}, {{"strict", isStrict}},
                isAny, results),
      caseTable({"avoidable", "Avoidable crashes", {}}, {{"avoidable", isAvoidable}}, isAny,
                results),
      caseTable({"avoidable_strict", "Avoidable crashes, of strict ones", {}},
                {{"avoidable", isAvoidable}}, isStrict, results),
      caseTable({"careful", "Crashes that a careful driver avoids", {}}, drivers, isAny, results),
      caseTable({"from_now", "Crashes that a manoeuvre from t0 avoids", {}}, manoeuvres, isAny,
                results)};
}

}  // namespace

std::vector<PlannerTable> plannerTables(const std::vector<PlannerTestResult>& results,
                                        const std::vector<std::string>& planners) {
  std::vector<PlannerTable> tables;
  for (const RolloutMeasure& measure : rolloutMeasures()) {
    tables.push_back(rolloutTable(measure, results, planners));
  }
  for (PlannerTable& table : avoidabilityTables(results)) {
    tables.push_back(std::move(table));
  }
  return tables;
}

std::string describeCases(const std::vector<PlannerTestResult>& results) {
  std::map<std::string, int> counts;
  for (const PlannerTestResult& result : results) ++counts[result.status];
  std::string text =
      counted(results.size(), "case") + ", tested: " + std::to_string(counts["OK"]) + "\n";
  for (const auto& [status, count] : counts) {
    if (status != "OK") text += "- not tested, " + status + ": " + std::to_string(count) + "\n";
  }
  return text;
}

std::vector<WorstCase> worstCases(const std::vector<PlannerTestResult>& results,
                                  const std::vector<std::string>& planners, std::size_t count) {
  std::vector<WorstCase> worst;
  for (const std::string& planner : planners) {
    std::vector<std::pair<PlannerContact, std::size_t>> contacts;  // and the result's index
    for (std::size_t i = 0; i < results.size(); ++i) {
      if (!results[i].isTested()) continue;
      for (const PlannerRow& row : results[i].rows) {
        if (rowName(row) == planner && row.is_fair && !hasFailed(row.outcome) &&
            hitsAttacker(row.outcome)) {
          contacts.emplace_back(*row.outcome.contact, i);
        }
      }
    }
    std::stable_sort(contacts.begin(), contacts.end(),
                     [](const auto& a, const auto& b) { return isMoreSevere(a.first, b.first); });
    std::set<std::string> scenes;
    for (const auto& contact : contacts) {
      if (scenes.size() >= count) break;
      if (scenes.insert(results[contact.second].scene).second) {
        worst.push_back({contact.second, planner});
      }
    }
  }
  return worst;
}

}  // namespace forge
