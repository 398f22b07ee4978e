#include "collision_forge/planner_test/planners/pdm_brake.h"

#include <algorithm>

namespace forge {

bool firesBrake(double speed, const std::optional<double>& collision,
                const PdmBrakeOptions& options) {
  return collision && *collision <= options.max_time && speed <= options.max_speed;
}

double brakeSpeed(double speed, double center_acceleration, const PdmBrakeOptions& options) {
  if (speed <= options.standing_speed) {
    return std::clamp(-options.standing_gain * speed - center_acceleration, -options.braking,
                      options.max_acceleration);
  }
  return options.overshoot * (speed + std::max(-options.gain * speed, -options.braking));
}

double centerAcceleration(const BicycleState& state, double curvature, double center_offset) {
  const double yaw_rate = state.speed * curvature;
  return state.acceleration + yaw_rate * yaw_rate * center_offset;
}

std::vector<Pose2> brakePoses(const Pose2& start, double speed, int steps, double step) {
  std::vector<Pose2> poses;
  for (int i = 0; i <= steps; ++i) poses.push_back(compose(start, {speed * step * i, 0.0, 0.0}));
  return poses;
}

}  // namespace forge
