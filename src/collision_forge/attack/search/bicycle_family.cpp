#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <unsupported/Eigen/AutoDiff>

#include "collision_forge/attack/search/trajectory_family.h"

namespace forge {
namespace {

constexpr int kIterations = 12;        // of damped least squares, at most
constexpr double kConvergence = 0.02;  // share of the cost; smaller gains end the iterations
constexpr double kTurnHeading = 0.8;   // rad; for larger turns to the arrival, a tight turn is also
                                       // tried
// Deviations that have the same weight in least squares:
constexpr double kPositionScale = 0.1;       // m
constexpr double kHeadingScale = 0.03;       // rad
constexpr double kSpeedScale = 3.0;          // m/s
constexpr double kAccelerationScale = 40.0;  // m/s2 at a knot
constexpr double kCurvatureScale = 1.0;      // 1/m at a knot

constexpr int kKnots = SteeringKnots::kCount;  // of acceleration, and the same number of curvature
constexpr int kUnknowns = 2 * kKnots;
using Knots = Eigen::Matrix<double, kUnknowns, 1>;
/// A number with its derivatives with respect to all knots.
using Sensitive = Eigen::AutoDiffScalar<Knots>;

/// The bicycle's state, with derivatives or without.
template <typename Scalar>
struct State {
  Scalar x, y, yaw, speed, acceleration, curvature;
};

template <typename Scalar>
Scalar bounded(const Scalar& value, const Scalar& low, const Scalar& high) {
  return value < low ? low : value > high ? high : value;
}

/// The bicycle's motion for given knots, clamped to the limits.
template <typename Scalar>
class Rollout {
 public:
  using Steering = Eigen::Matrix<Scalar, kUnknowns, 1>;

  Rollout(const DriveStart& start, double duration, const VehicleLimits& limits,
          const Steering& knots)
      : duration_(duration), step_(start.step), limits_(limits), knots_(knots) {
    const Motion& motion = start.motion;
    state_ = {Scalar(motion.pose.x),
              Scalar(motion.pose.y),
              Scalar(motion.pose.yaw),
              Scalar(std::max(motion.speed, 0.0)),
              Scalar(0.0),
              Scalar(0.0)};
  }

  /// Returns the state after `i` steps with its controls from then on. Must be called with
  /// ascending `i`.
  const State<Scalar>& steered(int i) {
    control(i * step_);
    return state_;
  }

  void advance(double step) {
    const Scalar distance = (state_.speed + 0.5 * step * state_.acceleration) * step;
    const Scalar turn = state_.curvature * distance;
    const Scalar yaw = state_.yaw + 0.5 * turn;
    using std::cos;
    using std::sin;
    state_.x += distance * cos(yaw);
    state_.y += distance * sin(yaw);
    state_.yaw += turn;
    state_.speed = bounded<Scalar>(state_.speed + state_.acceleration * step, Scalar(0.0),
                                   Scalar(limits_.max_speed));
  }

  /// Returns the state at the end of the steering.
  State<Scalar> end() {
    const int steps = static_cast<int>(std::ceil(duration_ / step_));
    for (int i = 0; i < steps; ++i) {
      steered(i);
      // The end lies between two steps.
      advance(std::min(step_, duration_ - i * step_));
    }
    return state_;
  }

 private:
  /// Interpolates the knots from index `first` on, evenly spaced over the steering.
  Scalar between(int first, double ratio) const {
    const double place = std::clamp(ratio, 0.0, 1.0) * (kKnots - 1);
    const int i = std::min(static_cast<int>(place), kKnots - 2);
    return knots_[first + i] + (place - i) * (knots_[first + i + 1] - knots_[first + i]);
  }

  void control(double t) {
    if (t >= duration_) {
      state_.acceleration = state_.curvature = Scalar(0.0);
      return;
    }
    const double ratio = t / duration_;
    const auto acceleration = bounded<Scalar>(between(0, ratio), Scalar(-limits_.max_braking),
                                              Scalar(limits_.max_forward_acceleration));
    state_.acceleration = bounded<Scalar>(acceleration, -state_.speed / step_,
                                          (limits_.max_speed - state_.speed) / step_);
    using std::sqrt;
    const double total = limits_.max_total_acceleration * limits_.max_total_acceleration;
    const Scalar spare = total - state_.acceleration * state_.acceleration;
    const Scalar across = spare > Scalar(kTiny) ? Scalar(sqrt(spare)) : Scalar(0.0);
    // The friction circle must also hold at the end of the step.
    const Scalar faster = state_.speed + state_.acceleration * step_;
    const Scalar speed = faster > state_.speed ? faster : state_.speed;
    Scalar bound(limits_.max_curvature);
    if (across < bound * speed * speed) bound = across / (speed * speed);
    state_.curvature = bounded<Scalar>(between(kKnots, ratio), -bound, bound);
  }

  static constexpr double kTiny = 1e-9;  // square roots below have no finite derivative

  double duration_;
  double step_;
  const VehicleLimits& limits_;
  Steering knots_;
  State<Scalar> state_;
};

/// Initial guess: constant acceleration over the straight distance, and the curvature of an arc to
/// the arrival.
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

/// Initial guess: change to a speed at which a tight turn is possible, then turn.
Knots aroundATurn(const DriveStart& start, const Arrival& arrival, const VehicleLimits& limits,
                  double side) {
  constexpr double kShare = 0.8;  // share of the maximum curvature and of its speed
  const double speed = kShare * std::sqrt(limits.max_total_acceleration / limits.max_curvature);
  const double change = (speed - start.motion.speed) / (0.4 * arrival.time);
  Knots knots = Knots::Zero();
  knots.head<2>().setConstant(
      std::clamp(change, -limits.max_braking, limits.max_forward_acceleration));
  knots.tail<kKnots - 1>().setConstant(side * kShare * limits.max_curvature);
  return knots;
}

/// Least-squares problem for one arrival.
class Problem {
 public:
  Problem(const DriveStart& start, const Arrival& arrival, const VehicleLimits& limits)
      : start_(start), arrival_(arrival), limits_(limits) {}

  /// Solves from an initial guess; empty if the arrival stays too far away.
  std::optional<Knots> solve(Knots knots) const {
    Residuals residuals = residualsAt(knots);
    double cost = residuals.squaredNorm();
    double damping = kFirstDamping;
    bool going_on = true;
    for (int i = 0; i < kIterations && going_on; ++i) {
      const double before = cost;
      going_on = step(knots, residuals, cost, damping) && before - cost >= kConvergence * before;
    }
    const double miss = residuals.head<2>().norm() * kPositionScale;
    return miss <= BicycleFamily::kMaxMiss ? std::make_optional(knots) : std::nullopt;
  }

 private:
  static constexpr int kReached = 4;  // residuals of the end state, followed by one per knot
  using Residuals = Eigen::Matrix<double, kReached + kUnknowns, 1>;
  using Jacobian = Eigen::Matrix<double, kReached + kUnknowns, kUnknowns>;
  static constexpr double kFirstDamping = 1e-2;
  static constexpr int kDampings = 3;  // tried per step

  Residuals residualsAt(const Knots& knots) const {
    const auto end = Rollout<double>(start_, arrival_.time, limits_, knots).end();
    Residuals residuals;
    residuals[0] = (end.x - arrival_.pose.x) / kPositionScale;
    residuals[1] = (end.y - arrival_.pose.y) / kPositionScale;
    residuals[2] = angleBetween(arrival_.pose.yaw, end.yaw) / kHeadingScale;
    residuals[3] = (end.speed - arrival_.speed) / kSpeedScale;
    residuals.segment<kKnots>(kReached) = knots.head<kKnots>() / kAccelerationScale;
    residuals.tail<kKnots>() = knots.tail<kKnots>() / kCurvatureScale;
    return residuals;
  }

  Jacobian jacobianAt(const Knots& knots) const {
    Eigen::Matrix<Sensitive, kUnknowns, 1> sensitive;
    for (int i = 0; i < kUnknowns; ++i) sensitive[i] = Sensitive(knots[i], kUnknowns, i);
    const auto end = Rollout<Sensitive>(start_, arrival_.time, limits_, sensitive).end();
    Jacobian jacobian = Jacobian::Zero();
    jacobian.row(0) = end.x.derivatives() / kPositionScale;
    jacobian.row(1) = end.y.derivatives() / kPositionScale;
    jacobian.row(2) = end.yaw.derivatives() / kHeadingScale;
    jacobian.row(3) = end.speed.derivatives() / kSpeedScale;
    auto own = jacobian.bottomRows<kUnknowns>().diagonal();
    own.head<kKnots>().setConstant(1.0 / kAccelerationScale);
    own.tail<kKnots>().setConstant(1.0 / kCurvatureScale);
    return jacobian;
  }

  /// Takes one damped step; returns false if no damping reduces the cost.
  bool step(Knots& knots, Residuals& residuals, double& cost, double& damping) const {
    const Jacobian jacobian = jacobianAt(knots);
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

  const DriveStart& start_;
  const Arrival& arrival_;
  const VehicleLimits& limits_;
};

}  // namespace

void BicycleFamily::roll(const DriveStart& start, const SteeringKnots& steering, double duration,
                         std::vector<TrajectoryPoint>& points) const {
  Knots knots;
  knots.head<kKnots>() =
      Eigen::Map<const Eigen::Matrix<double, kKnots, 1>>(steering.acceleration.data());
  knots.tail<kKnots>() =
      Eigen::Map<const Eigen::Matrix<double, kKnots, 1>>(steering.curvature.data());
  Rollout<double> rollout(start, duration, limits_, knots);
  points.resize(static_cast<std::size_t>(start.points));
  for (int i = 0; i < start.points; ++i) {
    const State<double>& state = rollout.steered(i);
    points[static_cast<std::size_t>(i)] = {start.now + i * start.step,
                                           {state.x, state.y, state.yaw},
                                           state.speed,
                                           state.acceleration,
                                           state.curvature};
    rollout.advance(start.step);
  }
}

std::optional<SteeringKnots> BicycleFamily::solve(const DriveStart& start,
                                                  const Arrival& arrival) const {
  const Problem problem(start, arrival, limits_);
  const Pose2 local = relativeTo(start.motion.pose, arrival.pose);
  std::optional<Knots> knots = problem.solve(alongAnArc(start, arrival, limits_));
  // Least squares finds no way around an obstacle in the cost: if the arc fails, try a tight turn
  // to the arrival's side, then to the other.
  const double side = local.y >= 0.0 ? 1.0 : -1.0;
  for (const double turn : {side, -side}) {
    if (knots || std::abs(local.yaw) < kTurnHeading) break;
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
