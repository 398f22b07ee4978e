#include "collision_forge/planners/speed_plan.h"

#include <algorithm>
#include <cmath>

namespace forge {
namespace {

/// A stretch of constant acceleration.
struct Stretch {
  double duration = 0.0;
  double acceleration = 0.0;
};

/// From a speed to another by `acceleration`, positive also for braking.
Stretch towards(double speed, double target_speed, double acceleration) {
  const double change = target_speed - speed;
  return {std::abs(change) / acceleration, std::copysign(acceleration, change)};
}

/// Drives the stretches one after the other, then on at constant speed.
SpeedPlan drive(double speed, const std::vector<Stretch>& stretches, double step, int steps) {
  SpeedPlan plan;
  for (int i = 0; i <= steps; ++i) {
    double left = step * i;
    double now = speed;
    double distance = 0.0;
    double acceleration = 0.0;
    for (const Stretch& stretch : stretches) {
      const double duration = std::min(left, stretch.duration);
      distance += (now + 0.5 * stretch.acceleration * duration) * duration;
      now += stretch.acceleration * duration;
      left -= duration;
      acceleration = duration < stretch.duration ? stretch.acceleration : 0.0;
      if (duration < stretch.duration) break;
    }
    plan.distances.push_back(distance + now * std::max(left, 0.0));
    plan.speeds.push_back(std::max(now, 0.0));
    plan.accelerations.push_back(acceleration);
  }
  return plan;
}

}  // namespace

std::vector<double> spread(double low, double high, int count) {
  if (count == 1) return {0.5 * (low + high)};
  std::vector<double> values;
  for (int i = 0; i < count; ++i) values.push_back(low + (high - low) * i / (count - 1));
  return values;
}

SpeedPlan planThrough(double speed, double middle_speed, double end_speed, double acceleration,
                      double step, int steps) {
  const Stretch first = towards(speed, middle_speed, acceleration);
  const double held = std::max(0.5 * step * steps - first.duration, 0.0);
  return drive(speed, {first, {held, 0.0}, towards(middle_speed, end_speed, acceleration)}, step,
               steps);
}

SpeedPlan planTowards(double speed, double target_speed, double acceleration, double step,
                      int steps) {
  return drive(speed, {towards(speed, target_speed, acceleration)}, step, steps);
}

}  // namespace forge
