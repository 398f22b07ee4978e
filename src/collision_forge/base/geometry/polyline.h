#pragma once

#include <vector>

#include "collision_forge/base/geometry/pose2.h"

namespace forge {

/// The closest point of a polyline to a query point.
struct PolylineProjection {
  double arc_length = 0.0;  ///< metres from the first point, within [0, length]
  double lateral = 0.0;   ///< m, `distance` with a sign, positive if the query point is left of the
                          ///< line; beyond an end, the offset from the line extended straight
  double distance = 0.0;  ///< m between the query point and the closest point, >= 0
  Pose2 pose;             ///< the closest point, yaw along the line, as poseAt()
};

/// An open chain of at least two distinct points, with arc lengths. The constructor drops points
/// within 1e-6 m of the one before, and throws std::invalid_argument for fewer than two, or a NaN.
class Polyline {
 public:
  /// `points`: the vertices in order, m, in any frame; queries are in the same frame.
  explicit Polyline(const std::vector<Vector2>& points);

  /// Returns the length of the line, m.
  double length() const { return arc_lengths_.back(); }
  /// Returns the points that the constructor kept, at least two.
  const std::vector<Vector2>& points() const { return points_; }
  /// Returns the arc length (m from the first point) of each element of points().
  const std::vector<double>& arcLengths() const { return arc_lengths_; }

  /// Returns the pose at an arc length (m from the first point). The yaw, in (-pi, pi], is the
  /// segment's at its middle and turns linearly between the middles of adjacent segments; beyond
  /// either end the line continues straight.
  Pose2 poseAt(double arc_length) const;

  /// Returns the projection of `point` (same frame as the points), of equally close ones the first;
  /// takes time proportional to the number of points.
  PolylineProjection project(const Vector2& point) const;

 private:
  std::vector<Vector2> points_;
  std::vector<double> arc_lengths_;
};

}  // namespace forge
