#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <vector>

#include "collision_forge/base/geometry/oriented_box.h"

namespace forge {

/// A polyline through poses, as PDM-Closed follows it. Progress is the length (m) along the
/// straight pieces and is clamped to the path. Two nodes may coincide. Global map frame.
class PdmPath {
 public:
  /// `nodes`: in driving order. Throws std::invalid_argument unless at least two nodes differ in
  /// position.
  explicit PdmPath(std::vector<Pose2> nodes);

  double length() const { return progress_.back(); }  ///< m
  /// Returns the pose at `progress` (m), clamped to [0, length()]. Interpolates position and
  /// heading linearly between the nodes; yaw is wrapped.
  Pose2 at(double progress) const;
  /// Returns the progress (m) of the place nearest to `point` (m), the first of equals.
  double project(const Vector2& point) const;
  /// Returns the path with every node moved `lateral` metres to its left (negative: right).
  PdmPath shifted(double lateral) const;
  /// Returns the part from the first node beyond `progress` (m) on, which thus begins up to a piece
  /// after it; at least the last two distinct nodes.
  PdmPath ahead(double progress) const;
  /// Returns whether the box touches the corridor within `half_width` metres of the path, which
  /// ends in squares that reach `half_width` beyond both ends.
  bool corridorTouches(const OrientedBox& box, double half_width) const;

 private:
  /// Some successive pieces of the path with their bounding box, to skip them fast.
  struct Stretch {
    std::size_t first = 0;  ///< index of the first node
    std::size_t last = 0;   ///< index of the last node
    Eigen::AlignedBox2d bounds;
  };

  std::vector<Pose2> nodes_;      // yaw not wrapped: continuous along the path
  std::vector<double> progress_;  ///< m, of each node
  std::vector<Stretch> stretches_;
};

}  // namespace forge
