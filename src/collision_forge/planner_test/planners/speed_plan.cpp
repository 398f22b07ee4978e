#include "collision_forge/planner_test/planners/speed_plan.h"

#include <algorithm>

namespace forge {
namespace {

/// Extends a plan towards `target` by `steps` steps.
void append(SpeedPlan& plan, double target, double acceleration, double step, int steps) {
  const double change = acceleration * step;
  for (int i = 0; i < steps; ++i) {
    const double now = plan.speeds.back();
    plan.speeds.push_back(now + std::clamp(target - now, -change, change));
    plan.distances.push_back(plan.distances.back() + step * plan.speeds.back());
  }
}

std::vector<double> targets(double speed, int count, int steps, const RuleBasedOptions& options) {
  const double change = options.max_acceleration * options.step * steps;
  return spread(std::max(speed - change, 0.0), std::min(speed + change, options.max_speed), count);
}

}  // namespace

std::vector<double> spread(double first, double last, int count) {
  if (count == 1) return {0.5 * (first + last)};
  std::vector<double> values;
  for (int i = 0; i < count; ++i) values.push_back(first + (last - first) / (count - 1) * i);
  values.back() = last;
  return values;
}

SpeedPlan planTowards(double speed, double target, double acceleration, double step, int steps) {
  SpeedPlan plan{{speed}, {0.0}};
  append(plan, target, acceleration, step, steps);
  return plan;
}

std::vector<SpeedProfile> speedProfiles(double speed, const RuleBasedOptions& options) {
  const int first_half = options.steps / 2;
  const int second_half = options.steps - first_half;
  std::vector<SpeedProfile> profiles;
  for (const double middle : targets(speed, options.middle_speeds, first_half, options)) {
    const SpeedPlan start =
        planTowards(speed, middle, options.max_acceleration, options.step, first_half);
    for (const double end :
         targets(start.speeds.back(), options.end_speeds, second_half, options)) {
      SpeedProfile& profile = profiles.emplace_back(SpeedProfile{middle, end, start});
      append(profile.plan, end, options.max_acceleration, options.step, second_half);
    }
  }
  return profiles;
}

}  // namespace forge
