#pragma once

#include <vector>

#include "collision_forge/base/map/lane_queries.h"

namespace forge {

/// Where a pose is, seen from a path: metres along it and to its left, and its heading from it.
struct PathPose {
  double along = 0.0;
  double across = 0.0;
  double lean = 0.0;  ///< rad, (-pi, pi]
};

/// A smooth way along lanes, with what driving along it needs: a uniform cubic B-spline of points
/// about a metre apart, so that position, heading and curvature are continuous.
class ReferencePath {
 public:
  /// A place on the path.
  struct Place {
    Pose2 pose;
    Vector2 heading;         ///< unit vector along the path, map frame
    double curvature = 0.0;  ///< 1/m, positive to the left
    double stretch = 1.0;    ///< metres of path per metre of arc length, below 1 in sharp bends
  };

  static constexpr double kBendSpacing = 1.0;  ///< m between bends()
  static constexpr std::size_t kMinControls = 4;

  /// A centreline (or several, joined), smoothed over a few metres: recorded centrelines have kinks
  /// that nobody drives.
  explicit ReferencePath(const Polyline& line);
  /// The path with the spacing() and controls() of another one, in metres. Throws
  /// std::invalid_argument for fewer than kMinControls points, a point that is not finite, and a
  /// spacing that is not finite or not positive.
  ReferencePath(double spacing, std::vector<Vector2> controls);

  /// The path so many metres to its left; it cuts bends that are tighter than that.
  ReferencePath beside(double across) const;

  double spacing() const { return spacing_; }
  const std::vector<Vector2>& controls() const { return controls_; }
  double length() const { return spacing_ * static_cast<double>(controls_.size() - 3); }
  /// Beyond either end the path goes straight on.
  Place at(double arc_length) const;
  /// How sharply it bends, from its begin on every kBendSpacing: 1/m, without a sign. No less than
  /// 1e-3, so that who goes straight on has a greatest speed, too.
  std::vector<double> bends() const;
  /// Arc length of the closest place.
  double project(const Vector2& point) const;
  /// Of a pose near the path.
  PathPose seen(const Pose2& pose) const;

 private:
  void setControls(const Polyline& line);

  double spacing_;                 // metres between controls
  std::vector<Vector2> controls_;  // of the spline, and one beyond either end
};

}  // namespace forge
