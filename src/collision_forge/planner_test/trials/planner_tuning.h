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
  std::string name;      ///< "default" with the values of planners.yaml, else a number
  PlannerValues values;  ///< of all keys in the grid
  TrialOptions options;  ///< with these values
};

/// Returns the defaults, then every other combination of the grid's values; the last key changes
/// fastest. Throws std::invalid_argument for more than 10,000.
std::vector<PlannerValues> combinationsOf(const PlannerGrid& grid, const PlannerValues& defaults);

/// Creates one variant per combination from planners.yaml with this text; `limits` are the ego's.
/// Throws ConfigError, naming `path`, for an invalid key or value.
std::vector<PlannerVariant> variantsOf(const PlannerGrid& grid, const std::string& path,
                                       const std::string& text, const VehicleLimits& limits);

/// Throws std::runtime_error with the first scene that is in both sets.
void checkHeldOut(const std::set<std::string>& train, const std::set<std::string>& test);

/// Tests all variants of one planner in one case: one row per variant. `trials` (untuned) decides
/// whether the case is avoidable; with `only_avoidable` an unavoidable case has no rows.
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
  Rate collision;         ///< as isCollision()
  double progress = 0.0;  ///< m along the route, mean
};

/// Returns the score of each variant, in order.
std::vector<VariantScore> scoreVariants(const std::vector<PlannerTestResult>& results,
                                        const std::vector<PlannerVariant>& variants);

/// Returns the index of the lowest collision rate; of equals the one with the most progress, then
/// the first (the default). Empty if no crash was avoidable.
std::optional<std::size_t> bestVariant(const std::vector<VariantScore>& scores);

/// Returns the table of collisions in avoidable crashes for results with rows "default" and
/// "tuned": both rates and their paired difference.
RateTable comparisonTable(const std::vector<PlannerTestResult>& results);

/// Returns a Markdown table of the keys with their values before and after.
std::string describeValues(const PlannerValues& before, const PlannerValues& after);

/// Returns a CSV text: a header, then one line per variant with its name, values, number of
/// avoidable crashes, collision rate with interval, progress, and whether it is the best.
std::string scoresCsv(const std::vector<PlannerVariant>& variants,
                      const std::vector<VariantScore>& scores, std::size_t best);

}  // namespace forge
