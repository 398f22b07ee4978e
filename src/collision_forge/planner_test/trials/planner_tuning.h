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

/// A planner with other numbers than those of planners.yaml.
struct PlannerVariant {
  std::string name;      ///< "default" with those of planners.yaml, else its number
  PlannerValues values;  ///< of all keys of the grid
  TrialOptions options;  ///< with these values
};

/// The defaults first, then every other combination of the grid's values; the last key changes
/// fastest. Throws std::invalid_argument for more than 10,000.
std::vector<PlannerValues> combinationsOf(const PlannerGrid& grid, const PlannerValues& defaults);

/// A variant a combination, of planners.yaml with this text; `limits` are those of the ego. Throws
/// ConfigError, naming `path`, for a key or value that the file cannot have.
std::vector<PlannerVariant> variantsOf(const PlannerGrid& grid, const std::string& path,
                                       const std::string& text, const VehicleLimits& limits);

/// Throws std::runtime_error naming the first scene that is in both.
void checkHeldOut(const std::set<std::string>& train, const std::set<std::string>& test);

/// A row a variant, of one planner; the case is judged by `trials`, the untuned. With
/// `only_avoidable` no rows where the crash is not avoidable: nobody is tuned on it.
PlannerTestResult testVariants(const PlannerCase& one, const std::string& planner,
                               const std::vector<PlannerVariant>& variants, bool only_avoidable,
                               Background background, const AnswerOptions& options,
                               const TrialOptions& trials);

/// What tuning makes rare: a contact with the attacker, a first contact with somebody else that the
/// planner is to blame for, a failure. Otherwise it would pay to hit others before the attacker.
bool isCollision(const RolloutOutcome& outcome);

/// How a variant did in the avoidable crashes.
struct VariantScore {
  Rate collision;         ///< as isCollision()
  double progress = 0.0;  ///< m along the route, mean
};

/// The score of each variant.
std::vector<VariantScore> scoreVariants(const std::vector<PlannerTestResult>& results,
                                        const std::vector<PlannerVariant>& variants);

/// The index of the lowest collision rate, of equals that of the most progress, of equals the first
/// (the default). Empty where no crash was avoidable.
std::optional<std::size_t> bestVariant(const std::vector<VariantScore>& scores);

/// Collisions in avoidable crashes, of results with rows "default" and "tuned": both, and by how
/// much tuning changes them, case by case.
RateTable comparisonTable(const std::vector<PlannerTestResult>& results);

/// The keys with their values before and after as Markdown.
std::string describeValues(const PlannerValues& before, const PlannerValues& after);

/// A line a variant under a line of names: its name, values, avoidable crashes, rate of collisions
/// with interval, progress, and whether it is the best; each with its end.
std::string scoresCsv(const std::vector<PlannerVariant>& variants,
                      const std::vector<VariantScore>& scores, std::size_t best);

}  // namespace forge
