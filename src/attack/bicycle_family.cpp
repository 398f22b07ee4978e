#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "attack/trajectory_family.h"

namespace forge {
namespace {

constexpr int kKnots = SteeringKnots::kCount;  // of acceleration, and as many of curvature
using Knots = Eigen::Matrix<double, 2 * kKnots, 1>;

/// Value of five knots, evenly spread over [0, 1].
double between(const Knots& knots, int first, double ratio) {
  const double place = std::clamp(ratio, 0.0, 1.0) * (kKnots - 1);
  const int i = std::min(static_cast<int>(place), kKnots - 2);
  return knots[first + i] + (place - i) * (knots[first + i + 1] - knots[first + i]);
}

/// The bicycle's motion for some knots, held to the limits.
class Rollout {
 public:
  Rollout(const DriveStart& start, double arrival_time, const VehicleLimits& limits)
      : start_(start), arrival_time_(arrival_time), limits_(limits) {}

  /// State at the arrival; `points` (may be null) gets all.
  TrajectoryPoint drive(const Knots& knots, std::vector<TrajectoryPoint>* points) const {
    TrajectoryPoint state{start_.now, start_.motion.pose, std::max(start_.motion.speed, 0.0), 0.0,
                          0.0};
    if (points) points->resize(static_cast<std::size_t>(start_.points));
    double t = 0.0;
    for (int i = 0; points ? i < start_.points : t < arrival_time_; ++i) {
      control(knots, t, state);
      if (points) (*points)[static_cast<std::size_t>(i)] = state;
      // The end lies between two steps.
      const double step = points ? start_.step : std::min(start_.step, arrival_time_ - t);
      advance(step, state);
      t += start_.step;
    }
    return state;
  }

 private:
  void control(const Knots& knots, double t, TrajectoryPoint& state) const {
    const bool driving = t < arrival_time_;
    const double ratio = t / arrival_time_;
    double acceleration = driving ? between(knots, 0, ratio) : 0.0;
    acceleration = std::clamp(acceleration, -limits_.max_braking, limits_.max_forward_acceleration);
    acceleration = std::clamp(acceleration, -state.speed / start_.step,
                              (limits_.max_speed - state.speed) / start_.step);
    state.acceleration = acceleration;
    const double across =
        std::sqrt(std::max(0.0, limits_.max_total_acceleration * limits_.max_total_acceleration -
                                    acceleration * acceleration));
    // The friction circle has to hold at the end of the step, too.
    const double speed = std::max(state.speed, state.speed + acceleration * start_.step);
    const double bound = std::min(limits_.max_curvature, across / std::max(speed * speed, 1e-3));
    state.curvature = driving ? std::clamp(between(knots, kKnots, ratio), -bound, bound) : 0.0;
  }

  static void advance(double step, TrajectoryPoint& state) {
    const double distance = std::max(0.0, (state.speed + 0.5 * state.acceleration * step) * step);
    const double turn = state.curvature * distance;
    const Pose2 middle{0.0, 0.0, state.pose.yaw + 0.5 * turn};
    const Vector2 heading = middle.heading();
    state.pose = {state.pose.x + distance * heading.x(), state.pose.y + distance * heading.y(),
                  state.pose.yaw + turn};
    state.speed = std::max(0.0, state.speed + state.acceleration * step);
    state.time += step;
  }

  const DriveStart& start_;
  double arrival_time_;
  const VehicleLimits& limits_;
};

}  // namespace

bool BicycleFamily::drive(const DriveStart& start, const Arrival& arrival,
                          std::vector<TrajectoryPoint>& points) const {
  const auto knots = solve(start, arrival);
  if (knots) roll(start, *knots, arrival.time, points);
  return knots.has_value();
}

void BicycleFamily::roll(const DriveStart& start, const SteeringKnots& steering, double duration,
                         std::vector<TrajectoryPoint>& points) const {
  Knots knots;
  knots.head<kKnots>() =
      Eigen::Map<const Eigen::Matrix<double, kKnots, 1>>(steering.acceleration.data());
  knots.tail<kKnots>() =
      Eigen::Map<const Eigen::Matrix<double, kKnots, 1>>(steering.curvature.data());
  Rollout(start, duration, limits_).drive(knots, &points);
}

std::optional<SteeringKnots> BicycleFamily::solve(const DriveStart& start,
                                                  const Arrival& arrival) const {
  constexpr int kResiduals = 4 + 2 * kKnots;
  const Rollout rollout(start, arrival.time, limits_);
  const double reach = (arrival.pose.position() - start.motion.pose.position()).norm();
  const auto residuals = [&](const Knots& knots) {
    const TrajectoryPoint end = rollout.drive(knots, nullptr);
    Eigen::Matrix<double, kResiduals, 1> r;
    r[0] = (end.pose.x - arrival.pose.x) / options_.position_scale;
    r[1] = (end.pose.y - arrival.pose.y) / options_.position_scale;
    r[2] = angleBetween(arrival.pose.yaw, end.pose.yaw) / options_.heading_scale;
    r[3] = (end.speed - arrival.speed) / options_.speed_scale;
    r.segment<kKnots>(4) = knots.head<kKnots>() / options_.acceleration_scale;
    r.tail<kKnots>() = knots.tail<kKnots>() / options_.curvature_scale;
    return r;
  };
  Knots knots = Knots::Zero();
  // The constant acceleration that covers the straight distance, and the bend of the arc there.
  const double needed =
      2.0 * (reach - start.motion.speed * arrival.time) / (arrival.time * arrival.time);
  knots.head<kKnots>().setConstant(
      std::clamp(needed, -0.5 * limits_.max_braking, limits_.max_forward_acceleration));
  const Pose2 local = relativeTo(start.motion.pose, arrival.pose);
  const double bend = 2.0 * local.y / std::max(1.0, reach * reach);
  knots.tail<kKnots>().setConstant(std::clamp(bend, -limits_.max_curvature, limits_.max_curvature));

  auto r = residuals(knots);
  double cost = r.squaredNorm();
  double damping = 1e-2;
  for (int iteration = 0; iteration < options_.iterations; ++iteration) {
    Eigen::Matrix<double, kResiduals, 2 * kKnots> jacobian;
    for (int i = 0; i < 2 * kKnots; ++i) {
      const double delta = i < kKnots ? 1e-2 : 1e-4;
      Knots moved = knots;
      moved[i] += delta;
      jacobian.col(i) = (residuals(moved) - r) / delta;
    }
    const Eigen::Matrix<double, 2 * kKnots, 2 * kKnots> normal = jacobian.transpose() * jacobian;
    const Knots gradient = jacobian.transpose() * r;
    bool improved = false;
    for (int attempt = 0; attempt < 3 && !improved; ++attempt) {
      Eigen::Matrix<double, 2 * kKnots, 2 * kKnots> damped = normal;
      damped.diagonal() *= 1.0 + damping;
      const Knots next = knots - damped.ldlt().solve(gradient);
      const auto next_r = residuals(next);
      const double next_cost = next_r.squaredNorm();
      improved = next_cost < cost;
      damping *= improved ? 0.3 : 8.0;
      if (!improved) continue;
      const bool converged = cost - next_cost < options_.convergence * cost;
      knots = next;
      r = next_r;
      cost = next_cost;
      if (converged) iteration = options_.iterations;
    }
    if (!improved) break;
  }
  if (r.head<2>().norm() * options_.position_scale > options_.max_miss) return std::nullopt;
  SteeringKnots steering;
  for (int i = 0; i < kKnots; ++i) {
    const auto at = static_cast<std::size_t>(i);
    steering.acceleration[at] =
        std::clamp(knots[i], -limits_.max_braking, limits_.max_forward_acceleration);
    steering.curvature[at] =
        std::clamp(knots[kKnots + i], -limits_.max_curvature, limits_.max_curvature);
  }
  return steering;
}

}  // namespace forge
