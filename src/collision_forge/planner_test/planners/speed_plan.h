#pragma once

#include <vector>

#include "collision_forge/planner_test/planners/rule_based_options.h"

namespace forge {

/// Speeds and distances along a path at each step, of the ego or of another agent's prediction.
/// Index i is after i steps, 0 is t0. Negative values are backwards.
struct SpeedPlan {
  std::vector<double> speeds;     ///< m/s
  std::vector<double> distances;  ///< m driven since t0; a step counts with the speed at its end
};

/// Returns `count` (> 0) evenly spaced numbers from `first` to `last` inclusive; their mean for a
/// count of 1. `last` may be less than `first`.
std::vector<double> spread(double first, double last, int count);

/// Returns a plan of `steps` steps of `step` seconds, so `steps` + 1 elements, that changes from
/// `speed` to `target` (m/s) by at most `acceleration` (m/s2, positive also for braking), then
/// keeps `target`; it may end before `target` is reached.
SpeedPlan planTowards(double speed, double target, double acceleration, double step, int steps);

/// A candidate of the ego: towards a middle speed in the first half of the steps (rounded down),
/// then towards an end speed.
struct SpeedProfile {
  double middle_speed = 0.0;  ///< m/s, target of the first half
  double end_speed = 0.0;     ///< m/s, target of the second half
  SpeedPlan plan;             ///< of all steps
};

/// Returns all combinations of middle speed (outer loop) and end speed, each from the lowest
/// reachable to the highest reachable and allowed; never backwards targets. If even the lowest
/// reachable speed exceeds `options.max_speed`, the speeds descend from it to `max_speed`. `speed`:
/// m/s at t0.
std::vector<SpeedProfile> speedProfiles(double speed, const RuleBasedOptions& options);

}  // namespace forge
