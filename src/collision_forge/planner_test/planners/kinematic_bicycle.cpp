#include "collision_forge/planner_test/planners/kinematic_bicycle.h"

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
  const double asked_steering = state.steering + command.steering_rate * duration;
  BicycleState next;
  next.acceleration =
      lagged(state.acceleration, asked_acceleration, options_.acceleration_lag, duration);
  next.steering =
      std::clamp(lagged(state.steering, asked_steering, options_.steering_lag, duration),
                 -options_.max_steering, options_.max_steering);
  next.speed = state.speed + next.acceleration * duration;
  const double driven = state.speed * duration;
  next.rear_axle.x = state.rear_axle.x + driven * std::cos(state.rear_axle.yaw);
  next.rear_axle.y = state.rear_axle.y + driven * std::sin(state.rear_axle.yaw);
  next.rear_axle.yaw = wrapAngle(state.rear_axle.yaw + driven * curvature(state));
  return next;
}

double KinematicBicycle::curvature(const BicycleState& state) const {
  return std::tan(state.steering) / options_.wheelbase;
}

BicycleState KinematicBicycle::stateOf(const TrajectoryPoint& point, double center_offset) const {
  BicycleState state;
  state.rear_axle = rearAxleOf(point.pose, center_offset);
  state.speed = point.speed;
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
