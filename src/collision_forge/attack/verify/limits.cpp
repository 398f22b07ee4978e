#include "collision_forge/attack/verify/limits.h"

#include <algorithm>
#include <cmath>

#include "collision_forge/base/scene/formatted.h"

namespace forge {
namespace {

constexpr double kBackwardSlack = 1e-3;      // m between two points, for rounding at standstill
constexpr double kDifferenceError = 0.05;    // m/s2, error of a second difference of positions
constexpr double kMaxSpeedDifference = 0.3;  // m/s; a change from full braking to full throttle

double totalAcceleration(const TrajectoryPoint& point) {
  const double across = point.speed * point.speed * point.curvature;
  return std::sqrt(point.acceleration * point.acceleration + across * across);
}

bool isFinite(const TrajectoryPoint& point) {
  return point.pose.isFinite() && std::isfinite(point.speed) && std::isfinite(point.acceleration) &&
         std::isfinite(point.curvature);
}

void checkPoint(const TrajectoryPoint& point, const VehicleLimits& limits, WorstLimit& worst) {
  worst.check("max_forward_acceleration", point.acceleration, limits.max_forward_acceleration);
  worst.check("max_braking", -point.acceleration, limits.max_braking);
  worst.check("max_total_acceleration", totalAcceleration(point), limits.max_total_acceleration);
  worst.check("max_speed", point.speed, limits.max_speed);
  worst.check("no_reversing", -point.speed, 0.0);
  if (point.speed >= limits.curvature_min_speed) {
    worst.check("max_curvature", std::abs(point.curvature), limits.max_curvature);
  }
}

Vector2 velocityOver(const TrajectoryPoint& a, const TrajectoryPoint& b) {
  return (b.pose.position() - a.pose.position()) / (b.time - a.time);
}

enum class Wanted { kWorst, kFirst };

std::optional<BrokenLimit> findBroken(const std::vector<TrajectoryPoint>& points, double start_yaw,
                                      double until, const VehicleLimits& limits, Wanted wanted) {
  WorstLimit worst;
  double slow_yaw = start_yaw;  // heading where the current slow stretch began
  double slow_distance = 0.0;   // m driven since
  const TrajectoryPoint* previous = nullptr;
  for (const TrajectoryPoint& point : points) {
    if (!isFinite(point)) return BrokenLimit{"finite", 0.0, 0.0};
    checkPoint(point, limits, worst);
    if (previous && previous->speed >= limits.curvature_min_speed) {
      slow_yaw = previous->pose.yaw;
      slow_distance = 0.0;
    }
    if (previous) {
      const Vector2 step = point.pose.position() - previous->pose.position();
      slow_distance += step.norm();
      worst.check("no_reversing", -step.dot(previous->pose.heading()), kBackwardSlack);
    }
    if (!previous || point.speed < limits.curvature_min_speed) {
      worst.check("heading_slack", std::abs(angleBetween(slow_yaw, point.pose.yaw)),
                  limits.heading_slack + limits.heading_per_metre * slow_distance);
    }
    if (point.time >= until || (wanted == Wanted::kFirst && worst.found())) break;
    previous = &point;
  }
  return worst.found();
}

}  // namespace

std::optional<BrokenLimit> findBrokenLimit(const std::vector<TrajectoryPoint>& points,
                                           double start_yaw, double until,
                                           const VehicleLimits& limits) {
  return findBroken(points, start_yaw, until, limits, Wanted::kWorst);
}

bool keepsLimits(const std::vector<TrajectoryPoint>& points, double start_yaw, double until,
                 const VehicleLimits& limits) {
  return !findBroken(points, start_yaw, until, limits, Wanted::kFirst) &&
         !findBrokenPositions(points, until, limits);
}

std::optional<BrokenLimit> findBrokenPositions(const std::vector<TrajectoryPoint>& points,
                                               double until, const VehicleLimits& limits) {
  WorstLimit worst;
  for (std::size_t i = 1; i + 1 < points.size() && points[i].time < until; ++i) {
    const TrajectoryPoint& point = points[i];
    const double duration = 0.5 * (points[i + 1].time - points[i - 1].time);
    const Vector2 before = velocityOver(points[i - 1], point);
    const Vector2 after = velocityOver(point, points[i + 1]);
    const Vector2 change = (after - before) / duration;
    const double total = change.norm() - kDifferenceError;
    worst.check("max_total_acceleration", total, limits.max_total_acceleration);
    if (total > std::min(limits.max_forward_acceleration, limits.max_braking)) {
      const double along = change.dot(point.pose.heading());
      worst.check("max_forward_acceleration", along - kDifferenceError,
                  limits.max_forward_acceleration);
      worst.check("max_braking", -along - kDifferenceError, limits.max_braking);
    }
    const auto [slower, faster] = std::minmax({before.norm(), after.norm()});
    const double speed = std::abs(point.speed);
    worst.check("speed_of_positions", std::max(slower - speed, speed - faster),
                kMaxSpeedDifference);
  }
  return worst.found();
}

std::string describe(const BrokenLimit& broken) {
  return formatted("%s %.3f > %.3f", broken.name, broken.value, broken.limit);
}

double effort(const std::vector<TrajectoryPoint>& points, double until,
              const VehicleLimits& limits) {
  double sum = 0.0;
  int count = 0;
  for (const TrajectoryPoint& point : points) {
    const double share = totalAcceleration(point) / limits.max_total_acceleration;
    sum += share * share;
    ++count;
    if (point.time >= until) break;
  }
  return count > 0 ? sum / count : 0.0;
}

double fastestSteering(const std::vector<TrajectoryPoint>& points, double until,
                       const VehicleLimits& limits) {
  double fastest = 0.0;
  for (std::size_t i = 1; i < points.size() && points[i - 1].time < until; ++i) {
    const TrajectoryPoint& before = points[i - 1];
    const TrajectoryPoint& point = points[i];
    if (std::min(before.speed, point.speed) < limits.curvature_min_speed) continue;
    const double rate = (point.curvature - before.curvature) / (point.time - before.time);
    fastest = std::max(fastest, std::abs(rate));
  }
  return fastest;
}

}  // namespace forge
