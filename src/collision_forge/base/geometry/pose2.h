#pragma once

#include <cmath>

#include <Eigen/Core>

namespace forge {

using Vector2 = Eigen::Vector2d;

/// Wraps an angle to (-pi, pi].
double wrapAngle(double angle);

/// Signed shortest turn from `from` to `to`, in (-pi, pi].
double angleBetween(double from, double to);

/// A planar pose: metres and radians, yaw counter-clockwise from +x (REP-103).
struct Pose2 {
  double x = 0.0;
  double y = 0.0;
  double yaw = 0.0;

  Vector2 position() const { return {x, y}; }
  /// Unit vector along the heading.
  Vector2 heading() const { return {std::cos(yaw), std::sin(yaw)}; }
  bool isFinite() const;
};

/// The pose `local`, given in the frame of `base`, in the frame that `base` is given in.
Pose2 compose(const Pose2& base, const Pose2& local);

/// The pose `target` seen from `base`: compose(base, relativeTo(base, target)) == target.
Pose2 relativeTo(const Pose2& base, const Pose2& target);

/// Position linear, yaw along the shorter turn; ratio 0 gives `a`, 1 gives `b`.
Pose2 interpolate(const Pose2& a, const Pose2& b, double ratio);

}  // namespace forge
