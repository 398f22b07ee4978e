#include "collision_forge/planners/kinematic_bicycle.h"

#include <algorithm>
#include <cmath>

namespace forge {
namespace {

/// A first-order lag over one step, as nuPlan discretises it.
double lagged(double value, double target, double lag, double duration) {
  return value + duration / (duration + lag) * (target - value);
}

}  // namespace

BicycleState KinematicBicycle::step(const BicycleState& state, const BicycleCommand& command,
                                    double duration) const {
  const double asked_acceleration =
      std::clamp(command.acceleration, -options_.max_braking, options_.max_acceleration);
  const double asked_steering = std::clamp(state.steering + command.steering_rate * duration,
                                           -options_.max_steering, options_.max_steering);
  BicycleState next;
  next.acceleration =
      lagged(state.acceleration, asked_acceleration, options_.acceleration_lag, duration);
  next.steering = lagged(state.steering, asked_steering, options_.steering_lag, duration);
  next.speed = state.speed + next.acceleration * duration;
  double driven = 0.5 * (state.speed + next.speed) * duration;
  if (next.speed < 0.0) {
    driven = -0.5 * state.speed * state.speed / next.acceleration;
    next.speed = 0.0;
    next.acceleration = 0.0;
  }
  const double turned = driven * curvature(next);
  const double middle = state.rear_axle.yaw + 0.5 * turned;
  next.rear_axle.x = state.rear_axle.x + driven * std::cos(middle);
  next.rear_axle.y = state.rear_axle.y + driven * std::sin(middle);
  next.rear_axle.yaw = wrapAngle(state.rear_axle.yaw + turned);
  return next;
}

double KinematicBicycle::curvature(const BicycleState& state) const {
  return std::tan(state.steering) / options_.wheelbase;
}

BicycleState KinematicBicycle::stateOf(const TrajectoryPoint& point, double center_offset) const {
  BicycleState state;
  state.rear_axle = rearAxleOf(point.pose, center_offset);
  state.speed = std::max(point.speed, 0.0);
  state.acceleration = point.acceleration;
  state.steering = std::clamp(std::atan(point.curvature * options_.wheelbase),
                              -options_.max_steering, options_.max_steering);
  return state;
}

TrajectoryPoint KinematicBicycle::pointOf(const BicycleState& state, double time,
                                          double center_offset) const {
  return {time, boxMiddleOf(state.rear_axle, center_offset), state.speed, state.acceleration,
          curvature(state)};
}

Pose2 rearAxleOf(const Pose2& box_middle, double center_offset) {
  return compose(box_middle, {-center_offset, 0.0, 0.0});
}

Pose2 boxMiddleOf(const Pose2& rear_axle, double center_offset) {
  return compose(rear_axle, {center_offset, 0.0, 0.0});
}

}  // namespace forge
