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
    const int steps =
        points ? start_.points : static_cast<int>(std::ceil(arrival_time_ / start_.step));
    for (int i = 0; i < steps; ++i) {
      const double t = i * start_.step;
      control(knots, t, state);
      state.time = start_.now + t;
      if (points) (*points)[static_cast<std::size_t>(i)] = state;
      // The end lies between two steps.
      const double step = points ? start_.step : std::min(start_.step, arrival_time_ - t);
      advance(step, state);
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
  }

  const DriveStart& start_;
  double arrival_time_;
  const VehicleLimits& limits_;
};

/// Knots of a constant acceleration that covers the straight distance, bent to the arc there.
Knots alongAnArc(const DriveStart& start, const Arrival& arrival, const VehicleLimits& limits) {
  const Pose2 local = relativeTo(start.motion.pose, arrival.pose);
  const double reach = local.position().norm();
  const double needed =
      2.0 * (reach - start.motion.speed * arrival.time) / (arrival.time * arrival.time);
  const double bend = 2.0 * local.y / std::max(1.0, reach * reach);
  Knots knots;
  knots.head<kKnots>().setConstant(
      std::clamp(needed, -0.5 * limits.max_braking, limits.max_forward_acceleration));
  knots.tail<kKnots>().setConstant(std::clamp(bend, -limits.max_curvature, limits.max_curvature));
  return knots;
}

/// Knots of a change to the speed at which a tight turn can be driven, then that turn.
Knots aroundATurn(const DriveStart& start, const Arrival& arrival, const VehicleLimits& limits,
                  double side) {
  constexpr double kShare = 0.8;  // of the tightest turn and its speed
  const double speed = kShare * std::sqrt(limits.max_total_acceleration / limits.max_curvature);
  const double change = (speed - start.motion.speed) / (0.4 * arrival.time);
  Knots knots = Knots::Zero();
  knots.head<2>().setConstant(
      std::clamp(change, -limits.max_braking, limits.max_forward_acceleration));
  knots.tail<kKnots - 1>().setConstant(side * kShare * limits.max_curvature);
  return knots;
}

/// Least squares for one arrival.
class Steering {
 public:
  Steering(const DriveStart& start, const Arrival& arrival, const VehicleLimits& limits,
           const BicycleOptions& options)
      : rollout_(start, arrival.time, limits), arrival_(arrival), options_(options) {}

  /// From a first guess; empty when the arrival stays too far away.
  std::optional<Knots> solve(Knots knots) const {
    Residuals residuals = residualsAt(knots);
    double cost = residuals.squaredNorm();
    double damping = kFirstDamping;
    bool going_on = true;
    for (int i = 0; i < options_.iterations && going_on; ++i) {
      const double before = cost;
      going_on =
          step(knots, residuals, cost, damping) && before - cost >= options_.convergence * before;
    }
    const double miss = residuals.head<2>().norm() * options_.position_scale;
    return miss <= options_.max_miss ? std::make_optional(knots) : std::nullopt;
  }

 private:
  static constexpr int kUnknowns = 2 * kKnots;
  using Residuals = Eigen::Matrix<double, 4 + kUnknowns, 1>;
  static constexpr double kFirstDamping = 1e-2;
  static constexpr int kDampings = 3;  // tried a step

  Residuals residualsAt(const Knots& knots) const {
    const TrajectoryPoint end = rollout_.drive(knots, nullptr);
    Residuals residuals;
    residuals[0] = (end.pose.x - arrival_.pose.x) / options_.position_scale;
    residuals[1] = (end.pose.y - arrival_.pose.y) / options_.position_scale;
    residuals[2] = angleBetween(arrival_.pose.yaw, end.pose.yaw) / options_.heading_scale;
    residuals[3] = (end.speed - arrival_.speed) / options_.speed_scale;
    residuals.segment<kKnots>(4) = knots.head<kKnots>() / options_.acceleration_scale;
    residuals.tail<kKnots>() = knots.tail<kKnots>() / options_.curvature_scale;
    return residuals;
  }

  /// One damped step; false when none of the dampings gains anything.
  bool step(Knots& knots, Residuals& residuals, double& cost, double& damping) const {
    Eigen::Matrix<double, 4 + kUnknowns, kUnknowns> jacobian;
    for (int i = 0; i < kUnknowns; ++i) {
      const double delta = i < kKnots ? 1e-2 : 1e-4;
      Knots moved = knots;
      moved[i] += delta;
      jacobian.col(i) = (residualsAt(moved) - residuals) / delta;
    }
    const Eigen::Matrix<double, kUnknowns, kUnknowns> normal = jacobian.transpose() * jacobian;
    const Knots gradient = jacobian.transpose() * residuals;
    for (int attempt = 0; attempt < kDampings; ++attempt) {
      Eigen::Matrix<double, kUnknowns, kUnknowns> damped = normal;
      damped.diagonal() *= 1.0 + damping;
      const Knots next = knots - damped.ldlt().solve(gradient);
      const Residuals next_residuals = residualsAt(next);
      const double next_cost = next_residuals.squaredNorm();
      if (next_cost < cost) {
        damping *= 0.3;
        knots = next;
        residuals = next_residuals;
        cost = next_cost;
        return true;
      }
      damping *= 8.0;
    }
    return false;
  }

  Rollout rollout_;
  const Arrival& arrival_;
  const BicycleOptions& options_;
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
  const Steering problem(start, arrival, limits_, options_);
  const Pose2 local = relativeTo(start.motion.pose, arrival.pose);
  std::optional<Knots> knots = problem.solve(alongAnArc(start, arrival, limits_));
  // Least squares finds no way around: where the arc leads nowhere, a tight turn to the side where
  // the arrival lies is tried, then one to the other.
  const double side = local.y >= 0.0 ? 1.0 : -1.0;
  for (const double turn : {side, -side}) {
    if (knots || std::abs(local.yaw) < options_.turn_heading) break;
    knots = problem.solve(aroundATurn(start, arrival, limits_, turn));
  }
  if (!knots) return std::nullopt;
  SteeringKnots steering;
  for (int i = 0; i < kKnots; ++i) {
    const auto at = static_cast<std::size_t>(i);
    steering.acceleration[at] = (*knots)[i];
    steering.curvature[at] = (*knots)[kKnots + i];
  }
  return steering;
}

}  // namespace forge
