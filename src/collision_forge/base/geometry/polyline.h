#pragma once

#include <vector>

#include "collision_forge/base/geometry/pose2.h"

namespace forge {

/// Where a point falls on a polyline.
struct PolylineProjection {
  double arc_length = 0.0;  ///< metres from the first point, within [0, length]
  double lateral = 0.0;     ///< metres, positive if the point is left of the line
                            ///< (or, beyond an end, of the line going straight on)
  double distance = 0.0;    ///< metres to the closest point of the line
  Pose2 pose;               ///< the closest point, yaw along the line
};

/// An open chain of points with its arc lengths. At least two distinct points; consecutive points
/// that coincide are dropped. Throws std::invalid_argument for fewer, or for a NaN.
class Polyline {
 public:
  explicit Polyline(const std::vector<Vector2>& points);

  double length() const { return arc_lengths_.back(); }
  const std::vector<Vector2>& points() const { return points_; }
  /// Metres from the first point, one a point.
  const std::vector<double>& arcLengths() const { return arc_lengths_; }

  /// Pose at an arc length, yaw along the line and turning linearly over each vertex's two
  /// neighbouring half segments; beyond either end the line goes straight on.
  Pose2 poseAt(double arc_length) const;

  PolylineProjection project(const Vector2& point) const;

 private:
  std::vector<Vector2> points_;
  std::vector<double> arc_lengths_;
};

}  // namespace forge
