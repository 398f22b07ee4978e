#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "collision_forge/planner_test/statistics/rate_table.h"
#include "collision_forge/planner_test/statistics/statistics.h"
#include "collision_forge/planner_test/trials/planner_grid.h"
#include "collision_forge/planner_test/trials/planner_result.h"

namespace forge {

/// A variant of a planner: planners.yaml with other values.
struct PlannerVariant {
  std::string name;      ///< "default" with the values of planners.yaml, else a number from 1 on
  PlannerValues values;  ///< of all keys in the grid
  TrialOptions options;  ///< of planners.yaml with these values
};

/// Returns the defaults (values of planners.yaml, which need not be in the grid), then every other
/// combination of the grid's values; the last key (in order of names) changes fastest. Throws
/// std::invalid_argument for a grid with more than 10,000.
std::vector<PlannerValues> combinationsOf(const PlannerGrid& grid, const PlannerValues& defaults);

/// Returns one variant per combination, the default first. `text`: content of planners.yaml;
/// `path`: its name for messages; `limits`: the ego's strict limits. Throws ConfigError, naming
/// `path`, for an invalid key or value, and as combinationsOf().
std::vector<PlannerVariant> variantsOf(const PlannerGrid& grid, const std::string& path,
                                       const std::string& text, const VehicleLimits& limits);

/// Throws std::runtime_error, naming the first common scene (by name), if `train` and `test` (names
/// of scenes) share one.
void checkHeldOut(const std::set<std::string>& train, const std::set<std::string>& test);

/// Tests all variants of one planner in one case against a fixed attacker: one row per variant,
/// with PlannerVariant::name as its planner. `trials` (untuned) decides whether the case is
/// avoidable. If `only_avoidable` is true, an unavoidable case has no rows, and the rows of other
/// cases have no motions. Throws as testPlanner().
PlannerTestResult testVariants(const PlannerCase& one, const std::string& planner,
                               const std::vector<PlannerVariant>& variants, bool only_avoidable,
                               Background background, const AnswerOptions& options,
                               const TrialOptions& trials);

/// Returns whether the rollout counts as a collision in tuning: a contact with the attacker, a
/// first contact with another agent at the planner's fault, or a failure. Counting only the
/// attacker would reward hitting other agents first.
bool isCollision(const RolloutOutcome& outcome);

/// Score of a variant in the avoidable crashes.
struct VariantScore {
  Rate collision;  ///< share of isCollision(); no trials if no crash was avoidable
  /// m along the route, mean over the rollouts that count in `collision`; 0 without
  double progress = 0.0;
};

/// Returns the score of each variant, in the order of `variants`. `results`: of testVariants().
std::vector<VariantScore> scoreVariants(const std::vector<PlannerTestResult>& results,
                                        const std::vector<PlannerVariant>& variants);

/// Returns the index in `scores` of the lowest collision rate; of exactly equal rates the one with
/// the most progress, then the first in `scores` (so the default before others). Scores without
/// trials do not count. nullopt if no variant has trials.
std::optional<std::size_t> bestVariant(const std::vector<VariantScore>& scores);

/// Returns the table of collisions (isCollision()) in avoidable crashes for results with rows
/// "default" and "tuned": both rates and "tuned - default", their paired difference. Only cases
/// with both rows count.
RateTable comparisonTable(const std::vector<PlannerTestResult>& results);

/// Returns a Markdown table with the columns "key of planners.yaml", "default" (`before`) and
/// "tuned" (`after`), one line per key of `before` by name. `after` must have the keys of `before`.
std::string describeValues(const PlannerValues& before, const PlannerValues& after);

/// Returns a CSV text: the header "variant,KEYS,avoidable,collision,low,high,progress,best" (a
/// column per key), then one line per variant with its name, values, number of avoidable crashes,
/// collision rate (0 without such crashes) with the ends of its interval (empty without one),
/// progress (m), and 1 if it is the best, else 0. `variants` must not be empty; `scores`: in their
/// order; `best`: index of the best variant.
std::string scoresCsv(const std::vector<PlannerVariant>& variants,
                      const std::vector<VariantScore>& scores, std::size_t best);

}  // namespace forge
