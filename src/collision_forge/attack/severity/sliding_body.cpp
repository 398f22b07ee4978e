#include "collision_forge/attack/severity/sliding_body.h"

#include <algorithm>
#include <cmath>

#include "collision_forge/base/scene/gravity.h"

namespace forge {
namespace {

// Wheels by the box: a wheelbase of 0.58 lengths, as in config/severity.yaml, and a track of 0.8
// widths.
constexpr double kAxleDistance = 0.29;  // of the length, from the centre
constexpr double kWheelDistance = 0.4;  // of the width, from the centre

// Slip (lateral over longitudinal speed) from which a rolling tyre has its full lateral force.
constexpr double kFullSlip = 0.12;

// Below this speed friction is proportional to the speed, so that a body comes to rest.
constexpr double kRestSpeed = 0.15;  // m/s

// A body stands below these.
constexpr double kStandSpeed = 0.03;    // m/s
constexpr double kStandYawRate = 0.02;  // rad/s

bool rollsOnWheels(AgentClass agent_class) {
  return isCarLike(agent_class) || agent_class == AgentClass::kTrailer;
}

Vector2 turned(const Vector2& vector, double angle) {
  return {std::cos(angle) * vector.x() - std::sin(angle) * vector.y(),
          std::sin(angle) * vector.x() + std::cos(angle) * vector.y()};
}

double saturated(double ratio) { return std::clamp(ratio, -1.0, 1.0); }

}  // namespace

SlidingBody::SlidingBody(const CrashedVehicle& party, const SeverityOptions& options)
    : body_(bodyOf(party, options)),
      pose_(party.state.pose),
      size_(party.size),
      options_(options.after_impact),
      has_wheels_(rollsOnWheels(party.agent_class)) {}

void SlidingBody::hit(const ImpactChange& change, const Vector2& point) {
  body_.velocity += change.velocity;
  body_.yaw_rate += change.yaw_rate;
  if (change.velocity.norm() < options_.locking_delta_v) return;
  const bool is_ahead = (point - body_.center).dot(pose_.heading()) >= 0.0;
  locked_[is_ahead ? 0 : 1] = true;
}

/// Returns the force on a wheel, N, in the vehicle's frame; `velocity` of its contact with the
/// road, m/s, in the same frame.
Vector2 SlidingBody::wheelForce(const Vector2& velocity, double load, bool is_locked,
                                bool is_braking) const {
  const double largest = (has_wheels_ ? options_.tyre_friction : options_.ground_friction) * load;
  if (!has_wheels_ || is_locked) {
    return -largest * velocity / std::max(velocity.norm(), kRestSpeed);
  }
  const double drag = options_.rolling_drag + (is_braking ? options_.braking / kGravity : 0.0);
  const double lateral_scale = std::max(kFullSlip * std::abs(velocity.x()), kRestSpeed);
  const Vector2 force(-drag * load * saturated(velocity.x() / kRestSpeed),
                      -largest * saturated(velocity.y() / lateral_scale));
  return force * std::min(1.0, largest / std::max(force.norm(), 1e-9));
}

void SlidingBody::move(double duration, bool is_braking) {
  const double load = body_.mass * kGravity / 4.0;
  const Vector2 velocity = turned(body_.velocity, -pose_.yaw);
  Vector2 force(0.0, 0.0);
  double moment = 0.0;
  for (const int end : {0, 1}) {
    for (const double side : {1.0, -1.0}) {
      const Vector2 arm((end == 0 ? 1.0 : -1.0) * kAxleDistance * size_.length,
                        side * kWheelDistance * size_.width);
      const Vector2 at_wheel = velocity + body_.yaw_rate * Vector2(-arm.y(), arm.x());
      const Vector2 on_wheel = wheelForce(at_wheel, load, locked_[end], is_braking);
      force += on_wheel;
      moment += arm.x() * on_wheel.y() - arm.y() * on_wheel.x();
    }
  }
  body_.velocity += duration / body_.mass * turned(force, pose_.yaw);
  body_.yaw_rate += duration / body_.yaw_inertia * moment;
  body_.center += duration * body_.velocity;
  pose_ = {body_.center.x(), body_.center.y(), pose_.yaw + duration * body_.yaw_rate};
}

bool SlidingBody::stands() const {
  return body_.velocity.norm() < kStandSpeed && std::abs(body_.yaw_rate) < kStandYawRate;
}

}  // namespace forge
