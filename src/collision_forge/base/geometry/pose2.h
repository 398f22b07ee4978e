#pragma once

#include <cmath>

#include <Eigen/Core>

namespace forge {

using Vector2 = Eigen::Vector2d;

/// Wraps an angle to (-pi, pi].
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
  bool isFinite() const;
};

/// Transforms `local` from the frame of `base` to the frame in which `base` is given.
Pose2 compose(const Pose2& base, const Pose2& local);

/// Returns `target` in the frame of `base`: compose(base, relativeTo(base, target)) == target.
Pose2 relativeTo(const Pose2& base, const Pose2& target);

/// Returns the pose between `a` (ratio 0) and `b` (ratio 1): position linear, yaw along the shorter
/// turn. Other ratios extrapolate.
Pose2 interpolate(const Pose2& a, const Pose2& b, double ratio);

}  // namespace forge
