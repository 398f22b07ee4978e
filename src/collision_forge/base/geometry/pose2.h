#pragma once

#include <cmath>

#include <Eigen/Core>

namespace forge {

/// A point or vector in the plane, x and y.
using Vector2 = Eigen::Vector2d;

/// Returns an angle (rad) wrapped to (-pi, pi]; NaN if it is not finite.
double wrapAngle(double angle);

/// Returns the signed shortest turn from `from` to `to` (rad), in (-pi, pi].
double angleBetween(double from, double to);

/// A planar pose: metres and radians, yaw counter-clockwise from +x (REP-103).
struct Pose2 {
  double x = 0.0;
  double y = 0.0;
  double yaw = 0.0;

  Vector2 position() const { return {x, y}; }
  /// Returns the unit vector along the yaw.
  Vector2 heading() const { return {std::cos(yaw), std::sin(yaw)}; }
  /// Returns true if x, y and yaw are finite.
  bool isFinite() const;
};

// The next three functions return yaws in (-pi, pi].

/// Returns `local`, a pose in the frame of `base`, in the frame in which `base` is given.
Pose2 compose(const Pose2& base, const Pose2& local);

/// Returns `target` in the frame of `base`: compose(base, relativeTo(base, target)) == target.
Pose2 relativeTo(const Pose2& base, const Pose2& target);

/// Returns the pose between `a` (ratio 0) and `b` (ratio 1): position linear, yaw along the shorter
/// turn. Other ratios extrapolate.
Pose2 interpolate(const Pose2& a, const Pose2& b, double ratio);

}  // namespace forge
