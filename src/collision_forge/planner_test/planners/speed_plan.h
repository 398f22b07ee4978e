#pragma once

#include <vector>

#include "collision_forge/planner_test/planners/rule_based_options.h"

namespace forge {

/// Speeds step by step: what the ego may do, or what it expects of others. Negative ones drive
/// backwards.
struct SpeedPlan {
  std::vector<double> speeds;     ///< m/s after each step, the first after none
  std::vector<double> distances;  ///< m driven then; a step counts with the speed at its end
};

/// `count` numbers evenly spread from one to another, both included; the middle for one. The last
/// may lie below the first.
std::vector<double> spread(double first, double last, int count);

/// From `speed` to `target` by at most `acceleration` (m/s2, positive also for braking), then on.
SpeedPlan planTowards(double speed, double target, double acceleration, double step, int steps);

/// One that the ego chooses from: to a middle speed for the first half of the steps (the shorter
/// one, where they are odd), then to an end speed.
struct SpeedProfile {
  double middle_speed = 0.0;  ///< m/s, aimed at
  double end_speed = 0.0;     ///< m/s, aimed at
  SpeedPlan plan;
};

/// For each middle speed each end speed, both from the lowest that can be reached to the highest
/// that can be reached and is allowed. If the ego is so fast that even the lowest is not allowed,
/// they descend from it to the highest allowed.
std::vector<SpeedProfile> speedProfiles(double speed, const RuleBasedOptions& options);

}  // namespace forge
