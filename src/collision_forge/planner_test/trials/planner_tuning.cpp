#include "collision_forge/planner_test/trials/planner_tuning.h"

#include <stdexcept>
#include <utility>

#include "collision_forge/base/config/section.h"
#include "collision_forge/base/scene/formatted.h"
#include "collision_forge/planner_test/statistics/rate_table.h"

namespace forge {
namespace {

constexpr std::size_t kMaxCombinations = 10'000;
constexpr const char* kDefault = "default";
constexpr const char* kTuned = "tuned";

std::size_t sizeOf(const PlannerGrid& grid) {
  std::size_t size = 1;
  for (const auto& entry : grid) {
    size *= entry.second.size();
    if (size > kMaxCombinations) {
      throw std::invalid_argument("the grid has more than " + std::to_string(kMaxCombinations) +
                                  " combinations");
    }
  }
  return size;
}

/// Returns the combination at an index; the last key changes fastest.
PlannerValues combinationAt(const PlannerGrid& grid, std::size_t index) {
  PlannerValues values;
  for (auto entry = grid.rbegin(); entry != grid.rend(); ++entry) {
    values[entry->first] = entry->second[index % entry->second.size()];
    index /= entry->second.size();
  }
  return values;
}

/// Returns 1 for a collision in an avoidable crash; empty in other cases and without a row of that
/// name.
std::optional<double> collisionOf(const PlannerTestResult& result, const std::string& name) {
  if (!result.isTested() || !result.avoidability.is_avoidable) return std::nullopt;
  for (const PlannerRow& row : result.rows) {
    if (row.planner == name) return isCollision(row.outcome) ? 1.0 : 0.0;
  }
  return std::nullopt;
}

void addTrial(std::vector<Trial>& trials, const PlannerTestResult& result, double value) {
  trials.push_back({result.scene, result.type, result.tta, value});
}

double meanProgress(const std::vector<PlannerTestResult>& results, const std::string& name) {
  double sum = 0.0;
  int count = 0;
  for (const PlannerTestResult& result : results) {
    if (!collisionOf(result, name)) continue;
    for (const PlannerRow& row : result.rows) {
      if (row.planner == name) sum += row.outcome.progress;
    }
    ++count;
  }
  return count > 0 ? sum / count : 0.0;
}

bool isBetter(const VariantScore& score, const VariantScore& than) {
  if (score.collision.value != than.collision.value) {
    return score.collision.value < than.collision.value;
  }
  return score.progress > than.progress;
}

}  // namespace

std::vector<PlannerValues> combinationsOf(const PlannerGrid& grid, const PlannerValues& defaults) {
  std::vector<PlannerValues> combinations = {defaults};
  const std::size_t size = sizeOf(grid);
  for (std::size_t index = 0; index < size; ++index) {
    PlannerValues values = combinationAt(grid, index);
    if (values != defaults) combinations.push_back(std::move(values));
  }
  return combinations;
}

std::vector<PlannerVariant> variantsOf(const PlannerGrid& grid, const std::string& path,
                                       const std::string& text, const VehicleLimits& limits) {
  std::vector<PlannerVariant> variants;
  for (PlannerValues& values : combinationsOf(grid, readPlannerValues(path, text, grid))) {
    PlannerVariant variant;
    variant.name = variants.empty() ? kDefault : std::to_string(variants.size());
    variant.values = std::move(values);
    variant.options = readTrialOptions(path, text, variant.values, limits);
    variants.push_back(std::move(variant));
  }
  return variants;
}

void checkHeldOut(const std::set<std::string>& train, const std::set<std::string>& test) {
  for (const std::string& scene : test) {
    if (train.count(scene) > 0) {
      throw std::runtime_error("scene = \"" + scene + "\" is in both --train and --test");
    }
  }
}

PlannerTestResult testVariants(const PlannerCase& one, const std::string& planner,
                               const std::vector<PlannerVariant>& variants, bool only_avoidable,
                               Background background, const AnswerOptions& options,
                               const TrialOptions& trials) {
  PlannerTestResult result = evaluateCase(one, options, trials);
  if (!result.isTested() || (only_avoidable && !result.avoidability.is_avoidable)) return result;
  const RowKey key{planner, PolicyKind::kFixed, background};
  for (const PlannerVariant& variant : variants) {
    result.rows.push_back(testPlanner(one, key, {}, options, variant.options));
    result.rows.back().planner = variant.name;
  }
  if (only_avoidable) dropMotions(result);  // saves memory: a result has a row for every variant
  return result;
}

bool isCollision(const RolloutOutcome& outcome) {
  if (outcome.failure != PlannerFailure::kNone) return true;
  return outcome.contact && (outcome.contact->is_attacker || outcome.contact->at_fault);
}

std::vector<VariantScore> scoreVariants(const std::vector<PlannerTestResult>& results,
                                        const std::vector<PlannerVariant>& variants) {
  std::vector<VariantScore> scores;
  for (const PlannerVariant& variant : variants) {
    std::vector<Trial> trials;
    for (const PlannerTestResult& result : results) {
      if (const auto value = collisionOf(result, variant.name)) addTrial(trials, result, *value);
    }
    scores.push_back({pooledRate(trials), meanProgress(results, variant.name)});
  }
  return scores;
}

std::optional<std::size_t> bestVariant(const std::vector<VariantScore>& scores) {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < scores.size(); ++i) {
    if (scores[i].collision.trials == 0) continue;
    if (!best || isBetter(scores[i], scores[*best])) best = i;
  }
  return best;
}

RateTable comparisonTable(const std::vector<PlannerTestResult>& results) {
  MethodTrials trials = {{kDefault, {}}, {kTuned, {}}, {"tuned - default", {}}};
  for (const PlannerTestResult& result : results) {
    const auto before = collisionOf(result, kDefault);
    const auto after = collisionOf(result, kTuned);
    if (!before || !after) continue;
    addTrial(trials[0].second, result, *before);
    addTrial(trials[1].second, result, *after);
    addTrial(trials[2].second, result, *after - *before);
  }
  return tabulateTrials({"tuned_collision",
                         "Collisions as counted in tuning (with the attacker, at fault, failures), "
                         "of avoidable crashes",
                         {}},
                        trials);
}

std::string describeValues(const PlannerValues& before, const PlannerValues& after) {
  std::string text = "| key of planners.yaml | default | tuned |\n|---|---|---|\n";
  for (const auto& [key, value] : before) {
    text += "| " + key + " | " + shortestText(value) + " | " + shortestText(after.at(key)) + " |\n";
  }
  return text;
}

std::string scoresCsv(const std::vector<PlannerVariant>& variants,
                      const std::vector<VariantScore>& scores, std::size_t best) {
  std::string text = "variant";
  for (const auto& entry : variants.front().values) text += ',' + entry.first;
  text += ",avoidable,collision,low,high,progress,best\n";
  for (std::size_t i = 0; i < variants.size(); ++i) {
    text += variants[i].name;
    for (const auto& entry : variants[i].values) text += ',' + shortestText(entry.second);
    const auto& [rate, progress] = scores[i];
    text += formatted(",%d,%.4f,", rate.trials, rate.value) + intervalCsv(rate) +
            formatted(",%.3f,%d\n", progress, i == best ? 1 : 0);
  }
  return text;
}

}  // namespace forge
