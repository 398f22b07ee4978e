#include "collision_forge/attack/verify/drive_check.h"

#include <algorithm>
#include <cmath>

namespace forge {
namespace {

// Tolerances for values derived from poses, because the state changes within a step.
constexpr double kSlip = 0.01;       // m across the mean heading per step
constexpr double kBackwards = 1e-3;  // m, for rounding at standstill
constexpr double kSlowWay = 0.05;  // m; a shorter step gives no steering angle: its turn is checked
constexpr double kSlowTurn = 2e-3;  // rad by which the turn of such a step may exceed the turn at
                                    // the maximum steering angle
constexpr double kAngleError = 0.005;         // rad
constexpr double kRateError = 0.02;           // rad/s
constexpr double kSpeedError = 0.05;          // m/s
constexpr double kAccelerationError = 0.05;   // m/s2
constexpr double kJerkError = 0.5;            // m/s3
constexpr double kStartDistance = 0.05;       // m between the first pose and the recorded one
constexpr double kStartTurn = 0.02;           // rad between the first yaw and the recorded one
constexpr double kWrittenSpeed = 0.3;         // m/s
constexpr double kWrittenAcceleration = 0.2;  // m/s2, in addition to the jerk within a step
constexpr double kWrittenCurvature = 0.002;   // 1/m, in addition to the steering within half a step

/// Motion of the rear axle between two points.
struct Step {
  double duration = 0.0;
  double along = 0.0;  // m along the mean heading
  double across = 0.0;
  double turn = 0.0;  // rad
  double speed() const { return along / duration; }
  double lateral() const { return speed() * turn / duration; }
};

Vector2 axleOf(const TrajectoryPoint& point, double axle_to_middle) {
  return point.pose.position() - axle_to_middle * point.pose.heading();
}

/// `way`: displacement of the rear axle, m.
Step stepBetween(const TrajectoryPoint& a, const TrajectoryPoint& b, const Vector2& way) {
  Step step;
  step.duration = b.time - a.time;
  step.turn = angleBetween(a.pose.yaw, b.pose.yaw);
  const Vector2 halfway = Pose2{0.0, 0.0, a.pose.yaw + 0.5 * step.turn}.heading();
  step.along = way.dot(halfway);
  step.across = halfway.x() * way.y() - halfway.y() * way.x();
  return step;
}

bool isFinite(const TrajectoryPoint& point) {
  return point.pose.isFinite() && std::isfinite(point.time) && std::isfinite(point.speed) &&
         std::isfinite(point.acceleration) && std::isfinite(point.curvature);
}

/// Returns the distance of `value` from the interval between `a` and `b`; 0 inside.
double outside(double value, double a, double b) {
  const auto [low, high] = std::minmax(a, b);
  return std::max({0.0, low - value, value - high});
}

/// Checks the steps of a trajectory one after the other.
class Check {
 public:
  Check(const DriveState& start, const DriveLimits& limits)
      : limits_(limits), max_tangent_(std::tan(limits.max_steering_angle)) {
    acceleration_ = start.acceleration;
    start_speed_ = start.speed;
    steering_ = start.steering;
    // A standing vehicle may have turned its wheels to any angle.
    steering_known_ = start.speed > 0.0;
  }

  void start(const TrajectoryPoint& point, const DriveState& start) {
    axle_ = axleOf(point, limits_.axle_to_middle);
    const Pose2 middle = compose(start.axle, {limits_.axle_to_middle, 0.0, 0.0});
    worst_.check("continues_pose", (point.pose.position() - middle.position()).norm(),
                 kStartDistance);
    worst_.check("continues_pose", std::abs(angleBetween(middle.yaw, point.pose.yaw)), kStartTurn);
  }

  void add(const TrajectoryPoint& from, const TrajectoryPoint& to) {
    const Vector2 axle = axleOf(to, limits_.axle_to_middle);
    const Step step = stepBetween(from, to, axle - axle_);
    axle_ = axle;
    const double speed = step.speed();
    worst_.check("no_reversing", -step.along, kBackwards);
    worst_.check("no_slip", std::abs(step.across), kSlip);
    worst_.check("max_speed", speed, limits_.max_speed + kSpeedError);
    checkAcceleration(step, from);
    checkSteering(step, from);
    is_first_ = false;
    before_ = step;
  }

  const std::optional<BrokenLimit>& found() const { return worst_.found(); }

 private:
  void checkAcceleration(const Step& step, const TrajectoryPoint& at) {
    const double speed = step.speed();
    const double lateral = std::abs(step.lateral());
    worst_.check("max_lateral_acceleration", lateral,
                 limits_.max_lateral_acceleration + kAccelerationError);
    if (is_first_) {
      const double change = (speed - start_speed_) / (0.5 * step.duration);
      worst_.check("continues_speed", std::abs(change - acceleration_),
                   0.5 * limits_.max_jerk * step.duration + kAccelerationError);
    } else {
      const double between = 0.5 * (before_.duration + step.duration);
      const double acceleration = (speed - before_.speed()) / between;
      const double faster = std::max(speed, before_.speed());
      worst_.check("max_forward_acceleration", acceleration,
                   limits_.forwardAt(faster) + kAccelerationError);
      worst_.check("max_braking", -acceleration, limits_.max_braking + kAccelerationError);
      worst_.check("total_acceleration", std::hypot(acceleration, lateral),
                   limits_.max_braking + kAccelerationError);
      worst_.check("max_jerk", std::abs(acceleration - acceleration_) / between,
                   limits_.max_jerk + kJerkError);
      worst_.check("written_acceleration", std::abs(at.acceleration - acceleration),
                   0.25 * between * limits_.max_jerk + kWrittenAcceleration);
      worst_.check("max_forward_acceleration", at.acceleration,
                   limits_.forwardAt(at.speed) + kAccelerationError);
      worst_.check("total_acceleration",
                   std::hypot(at.acceleration, at.speed * at.speed * at.curvature),
                   limits_.max_braking + kAccelerationError);
      worst_.check("written_speed", outside(at.speed, speed, before_.speed()), kWrittenSpeed);
      acceleration_ = acceleration;
    }
  }

  void checkSteering(const Step& step, const TrajectoryPoint& at) {
    since_steering_ += (is_first_ ? 0.5 : 1.0) * step.duration;
    if (step.along < kSlowWay) {
      worst_.check("max_steering_angle", std::abs(step.turn),
                   max_tangent_ / limits_.wheelbase * std::max(0.0, step.along) + kSlowTurn);
      return;
    }
    const double curvature = step.turn / step.along;
    const double steering = std::atan(limits_.wheelbase * curvature);
    worst_.check("max_steering_angle", std::abs(steering),
                 limits_.max_steering_angle + kAngleError);
    if (steering_known_) {
      worst_.check("max_steering_rate", std::abs(steering - steering_) / since_steering_,
                   limits_.max_steering_rate + kRateError);
      const double before = std::tan(steering_) / limits_.wheelbase;
      const double bend = 1.0 + max_tangent_ * max_tangent_;
      const double within = 0.5 * step.duration * limits_.max_steering_rate * bend;
      worst_.check("written_curvature", outside(at.curvature, curvature, before),
                   within / limits_.wheelbase + kWrittenCurvature);
    }
    steering_ = steering;
    steering_known_ = true;
    since_steering_ = 0.0;
  }

  const DriveLimits& limits_;
  double max_tangent_;
  WorstLimit worst_;
  Vector2 axle_ = Vector2::Zero();  // rear axle at the last point
  bool is_first_ = true;
  Step before_;
  double start_speed_ = 0.0;
  double acceleration_ = 0.0;
  double steering_ = 0.0;
  bool steering_known_ = false;
  double since_steering_ = 0.0;  // s since the steering angle was last known
};

}  // namespace

DriveState driveStateOf(const TrajectoryPoint& point, const DriveLimits& limits) {
  return {compose(point.pose, {-limits.axle_to_middle, 0.0, 0.0}), point.speed, point.acceleration,
          std::atan(limits.wheelbase * point.curvature)};
}

std::optional<BrokenLimit> findBrokenDrive(const std::vector<TrajectoryPoint>& points,
                                           const DriveState& start, double until,
                                           const DriveLimits& limits) {
  Check check(start, limits);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!isFinite(points[i])) return BrokenLimit{"finite", 0.0, 0.0};
    if (i == 0) {
      check.start(points[i], start);
      continue;
    }
    check.add(points[i - 1], points[i]);
    if (points[i].time >= until) break;
  }
  return check.found();
}

}  // namespace forge
