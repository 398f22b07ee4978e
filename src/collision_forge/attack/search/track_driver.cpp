#include "collision_forge/attack/search/track_driver.h"

#include <algorithm>
#include <cmath>

namespace forge {
namespace {

constexpr double kSpeedGain = 2.0;  // 1/s, gain on speed error
constexpr double kWayGain = 1.0;  // 1/s2, gain on distance error: critically damped with kSpeedGain
constexpr double kSteeringTime = 0.3;   // s, time constant of steering
constexpr double kPedalTime = 0.2;      // s, time constant of pedals
constexpr double kStanding = 0.02;      // m/s; slower is standing
constexpr double kStopping = 3.0;       // 1/s, decay of the last speed before a stop
constexpr double kStraight = 1e-3;      // 1/m; smaller curvature does not limit speed
constexpr double kNearestTarget = 1.0;  // m; nearer targets are not steered to

/// Returns `direction` turned by the angle of the unit vector `turn`.
Vector2 turned(const Vector2& direction, const Vector2& turn) {
  return {direction.x() * turn.x() - direction.y() * turn.y(),
          direction.x() * turn.y() + direction.y() * turn.x()};
}

/// Moves `from` towards `wanted` by `share` of the difference.
double smoothed(double wanted, double from, double share) {
  return from + std::min(1.0, share) * (wanted - from);
}

/// Returns the largest acceleration (m/s2) at the end of a step of `step` s that keeps
/// DriveLimits::forwardAt() at the speed at that end.
double mostForward(const DriveLimits& limits, const DriveState& state, double step) {
  const double most = limits.max_forward_acceleration;
  // The speed changes by the mean of both accelerations; here by the first one alone.
  const double speed = state.speed + 0.5 * state.acceleration * step;
  if (speed + 0.5 * most * step <= limits.switching_speed) return most;
  // Solves acceleration * (speed + acceleration * step / 2) = power.
  const double power = most * limits.switching_speed;
  return (std::sqrt(speed * speed + 2.0 * power * step) - speed) / step;
}

DriveLimits scaled(DriveLimits limits, double margin) {
  limits.max_steering_angle *= margin;
  limits.max_steering_rate *= margin;
  limits.max_lateral_acceleration *= margin;
  limits.max_forward_acceleration *= margin;
  limits.max_braking *= margin;
  limits.max_jerk *= margin;
  limits.max_speed *= margin;
  return limits;
}

}  // namespace

TrackDriver::TrackDriver(const DriveLimits& limits, double margin, double preview, double step)
    : limits_(scaled(limits, margin)),
      max_tangent_(std::tan(limits_.max_steering_angle)),
      preview_(static_cast<std::size_t>(std::max(1L, std::lround(preview / step)))),
      step_(step) {}

/// Returns the steering angle at which the rear axle follows an arc through the target's rear axle.
double TrackDriver::steeringTo(const DriveState& state, const Vector2& heading,
                               const PlannedStep& target) const {
  const Vector2 to =
      target.middle - limits_.axle_to_middle * target.heading - state.axle.position();
  const double distance = to.squaredNorm();
  if (distance < kNearestTarget * kNearestTarget || to.dot(heading) <= 0.0) return state.steering;
  const double curvature = 2.0 * (heading.x() * to.y() - heading.y() * to.x()) / distance;
  return std::atan(limits_.wheelbase * curvature);
}

double TrackDriver::nextSteering(double wanted, const DriveState& state) const {
  const double change = limits_.max_steering_rate * step_;
  const double towards = smoothed(wanted, state.steering, step_ / kSteeringTime);
  double most = limits_.max_steering_angle;
  const double faster = state.speed + std::max(0.0, state.acceleration) * step_;
  const double squared = faster * faster;
  const double total = limits_.max_braking * limits_.max_braking;
  const double across =
      std::min(limits_.max_lateral_acceleration,
               std::sqrt(std::max(0.0, total - state.acceleration * state.acceleration)));
  const double tangent = limits_.wheelbase * across;
  if (tangent < squared * max_tangent_) most = std::atan(tangent / squared);
  // The rate limit has priority over the grip limit.
  return std::clamp(std::clamp(towards, -most, most), state.steering - change,
                    state.steering + change);
}

double TrackDriver::nextAcceleration(double wanted, double tangent, double next_tangent,
                                     const DriveState& state) const {
  const double change = limits_.max_jerk * step_;
  const double tightest = std::max(std::abs(tangent), std::abs(next_tangent));
  // At the highest possible next speed, because lateral acceleration grows with its square.
  const double faster = state.speed + std::max(0.0, state.acceleration + change) * step_;
  const double lateral = faster * faster * tightest / limits_.wheelbase;
  const double grip =
      std::sqrt(std::max(0.0, limits_.max_braking * limits_.max_braking - lateral * lateral));
  // Releases the brakes in time to stop without a jerk.
  const double softly = std::min(kStopping, limits_.max_jerk / limits_.max_braking) * state.speed;
  const double least = -std::min(grip, softly);
  double most = std::min(grip, mostForward(limits_, state, step_));
  most = std::min(most, (limits_.max_speed - state.speed) / step_);
  if (const double bend = std::abs(next_tangent) / limits_.wheelbase; bend > kStraight) {
    // The speed changes by the mean of both accelerations.
    const double fastest = std::sqrt(limits_.max_lateral_acceleration / bend);
    most = std::min(most, 2.0 * (fastest - state.speed) / step_ - state.acceleration);
  }
  const double towards = smoothed(wanted, state.acceleration, step_ / kPedalTime);
  const double held = std::clamp(towards, least, std::max(least, most));
  return std::clamp(held, state.acceleration - change, state.acceleration + change);
}

void TrackDriver::drive(const DriveState& start, double now, const std::vector<PlannedStep>& plan,
                        std::vector<TrajectoryPoint>& points) const {
  DriveState state = start;
  Vector2 heading = state.axle.heading();
  double tangent = std::tan(state.steering);
  points.resize(plan.size());
  for (std::size_t i = 0; i < plan.size(); ++i) {
    const Vector2 middle = state.axle.position() + limits_.axle_to_middle * heading;
    points[i] = {now + static_cast<double>(i) * step_,
                 {middle.x(), middle.y(), wrapAngle(state.axle.yaw)},
                 state.speed,
                 state.acceleration,
                 tangent / limits_.wheelbase};
    if (i + 1 == plan.size()) break;
    PlannedStep target = plan[std::min(i + preview_, plan.size() - 1)];
    if (i + preview_ >= plan.size()) {
      const double beyond = static_cast<double>(i + preview_ + 1 - plan.size()) * step_;
      target.middle += beyond * std::max(1.0, target.speed) * target.heading;
    }
    const double steering = nextSteering(steeringTo(state, heading, target), state);
    const double next_tangent = std::tan(steering);
    const double behind = (plan[i].middle - middle).dot(heading);
    const double wanted = (plan[i + 1].speed - plan[i].speed) / step_ +
                          kSpeedGain * (plan[i].speed - state.speed) + kWayGain * behind;
    const double acceleration = nextAcceleration(wanted, tangent, next_tangent, state);
    // Steering angle and acceleration change linearly over the step.
    const double faster =
        std::max(0.0, state.speed + 0.5 * (state.acceleration + acceleration) * step_);
    const double way = std::max(
        0.0, (state.speed + (2.0 * state.acceleration + acceleration) / 6.0 * step_) * step_);
    const double turn = way * std::tan(0.5 * (state.steering + steering)) / limits_.wheelbase;
    const Vector2 half_turn = Pose2{0.0, 0.0, 0.5 * turn}.heading();
    const Vector2 halfway = turned(heading, half_turn);
    state.axle = {state.axle.x + way * halfway.x(), state.axle.y + way * halfway.y(),
                  state.axle.yaw + turn};
    heading = turned(halfway, half_turn);
    state.speed = faster < kStanding && acceleration < 0.0 ? 0.0 : faster;
    state.acceleration = state.speed > 0.0 ? acceleration : 0.0;
    state.steering = steering;
    tangent = next_tangent;
  }
}

}  // namespace forge
