#pragma once

#include <vector>

#include "collision_forge/base/map/lane_queries.h"

namespace forge {

/// A pose relative to a path (Frenet coordinates), both in the map frame.
struct PathPose {
  double along = 0.0;   ///< m, arc length from the start of the path; may be beyond either end
  double across = 0.0;  ///< m to the left of the path, negative: to the right
  double lean = 0.0;    ///< rad, the pose's yaw minus the path's, (-pi, pi]
};

/// A smooth path along lanes: a uniform cubic B-spline of points about 1 m apart, so that position,
/// heading and curvature are continuous.
class ReferencePath {
 public:
  /// A point of the path.
  struct PathPoint {
    Pose2 pose;              ///< map frame, yaw along the path
    Vector2 heading;         ///< unit vector along the path, map frame
    double curvature = 0.0;  ///< 1/m, positive to the left
    /// True length of the curve (m) per m of arc length, below 1 in sharp bends.
    double stretch = 1.0;
  };

  static constexpr double kBendSpacing = 1.0;     ///< m between curvatures()
  static constexpr std::size_t kMinControls = 4;  ///< control points of a cubic with one piece

  /// Smooths a centreline (or several joined ones) over a few metres: recorded centrelines have
  /// kinks that no driver follows. The path begins and ends at the ends of `line`; it has one piece
  /// per m, rounded, at least one.
  explicit ReferencePath(const Polyline& line);
  /// Restores a path from its spacing() (m) and controls() (map frame). Throws
  /// std::invalid_argument for fewer than kMinControls points, a point that is not finite, and a
  /// spacing that is not finite and positive.
  ReferencePath(double spacing, std::vector<Vector2> controls);

  /// Returns the parallel path `across` metres to the left (negative: right). Cuts bends towards
  /// that side with a radius below 1.25 times |`across`|, where it would run backwards. Throws
  /// std::invalid_argument if that leaves fewer than two distinct points.
  ReferencePath beside(double across) const;

  /// Returns the arc length (m) between two control points.
  double spacing() const { return spacing_; }
  /// Returns the control points of the spline (m, map frame), one beyond either end included; the
  /// curve runs near them, not through them.
  const std::vector<Vector2>& controls() const { return controls_; }
  /// Returns the nominal length of the path, m: the range of arc lengths of at().
  double length() const { return spacing_ * static_cast<double>(controls_.size() - 3); }
  /// Returns the point at an arc length (m); beyond either end the path continues straight, with
  /// curvature 0 and stretch 1.
  PathPoint at(double arc_length) const;
  /// Returns |curvature| (1/m) at 0, kBendSpacing, 2 kBendSpacing, ... up to the last multiple that
  /// is not beyond length(); each at least 1e-3, so that a speed limit in bends is finite on
  /// straights.
  std::vector<double> curvatures() const;
  /// Returns the arc length (m) of the point of the path closest to `point` (map frame), to first
  /// order from the closest control point (the first of equally close ones); may be beyond either
  /// end (negative before the start).
  double project(const Vector2& point) const;
  /// Returns the Frenet coordinates of a pose (map frame) near the path, in the frame of the pose
  /// at project().
  PathPose frenetOf(const Pose2& pose) const;

 private:
  /// Sets spacing_ and controls_ so that the spline follows `line` from end to end.
  void setControls(const Polyline& line);
  /// Sets widest_.
  void measureControls();
  /// Returns the index of the control closest to `point`, the first and last control excluded.
  std::size_t closestControl(const Vector2& point) const;

  double spacing_;                 // metres between controls
  std::vector<Vector2> controls_;  // of the spline, and one beyond either end
  double widest_ = 0.0;            // m, greatest distance between neighbouring controls
};

}  // namespace forge
