#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <vector>

#include "collision_forge/base/geometry/oriented_box.h"

namespace forge {

/// A line through nodes with headings, as PDM-Closed follows it: progress is the length along the
/// straight pieces between the nodes, in metres; places beyond either end are the end. Two nodes
/// may lie at one place. Global map frame.
class PdmPath {
 public:
  /// Throws std::invalid_argument for nodes without two distinct places.
  explicit PdmPath(std::vector<Pose2> nodes);

  double length() const { return progress_.back(); }
  /// Position and heading linear between the nodes; yaw wrapped.
  Pose2 at(double progress) const;
  /// Progress of the nearest place, the first of equals.
  double project(const Vector2& point) const;
  /// Every node moved `lateral` metres to its left.
  PdmPath shifted(double lateral) const;
  /// From the first node ahead of `progress` on; the last two nodes at least.
  PdmPath ahead(double progress) const;
  /// True when the box touches what lies within `half_width` metres of the path or, beyond its
  /// ends, within the squares of that half width.
  bool corridorTouches(const OrientedBox& box, double half_width) const;

 private:
  struct Stretch {
    std::size_t first = 0;  // of its pieces
    std::size_t last = 0;   // one after
    Eigen::AlignedBox2d bounds;
  };

  std::vector<Pose2> nodes_;      // yaw not wrapped: continuous along the path
  std::vector<double> progress_;  // of each node
  std::vector<Stretch> stretches_;
};

}  // namespace forge
