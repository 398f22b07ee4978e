#pragma once

#include <vector>

namespace forge {

/// Speeds that change by constant accelerations: what the ego may do, or what it expects of others.
struct SpeedPlan {
  std::vector<double> distances;      ///< m driven after each step, the first after none
  std::vector<double> speeds;         ///< m/s then
  std::vector<double> accelerations;  ///< m/s2 from then on
};

/// `count` numbers evenly spread over a range, both ends included; its middle for one.
std::vector<double> spread(double low, double high, int count);

/// From `speed` to `middle_speed`, which is held until half of `steps`, then to `end_speed`, which
/// is held. Speeds change by `acceleration` (m/s2, positive also for braking).
SpeedPlan planThrough(double speed, double middle_speed, double end_speed, double acceleration,
                      double step, int steps);

/// From `speed` to `target_speed` by `acceleration` (m/s2, positive also for braking), then on.
SpeedPlan planTowards(double speed, double target_speed, double acceleration, double step,
                      int steps);

}  // namespace forge
