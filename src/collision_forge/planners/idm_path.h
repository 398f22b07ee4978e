#pragma once

#include <cstddef>
#include <vector>

#include "collision_forge/geometry/oriented_box.h"
#include "collision_forge/geometry/polyline.h"

namespace forge {

/// A path through poses as nuPlan's IDM planner interpolates it: position and heading linear over
/// the arc length. Of nodes that coincide the last counts, and the path ends at the last node but
/// one. Nodes far apart are filled up, so that the path is not cut short by a whole road.
class IdmPath {
 public:
  /// Throws std::invalid_argument for fewer than two distinct nodes, or one that is not finite.
  explicit IdmPath(const std::vector<Pose2>& nodes);

  /// Arc length of its end, m.
  double end() const { return arc_lengths_.back(); }
  /// The arc length nearest to a point; it may lie beyond the end, up to the last node.
  double project(const Vector2& point) const { return line_.project(point).arc_length; }
  /// Clamped to the path.
  Pose2 at(double arc_length) const;

  const std::vector<Pose2>& nodes() const { return nodes_; }
  /// Index of the last node at or before an arc length.
  std::size_t nodeBefore(double arc_length) const;

 private:
  Polyline line_;  // with the last node
  std::vector<Pose2> nodes_;
  std::vector<double> arc_lengths_;
};

/// The ground within half a width of a path, with square ends, and a box at each place of it: what
/// is asked for touches it from a place of the path on.
class IdmCorridor {
 public:
  IdmCorridor(const IdmPath& path, const std::vector<OrientedBox>& others, double width);

  /// True when other number `index` reaches into the corridor from `arc_length` to the path's end.
  bool isTouched(std::size_t index, double arc_length) const;

 private:
  const IdmPath& path_;
  std::vector<OrientedBox> others_;
  double width_;
  std::vector<std::size_t> touched_before_;  // one an other: after the last node touched; 0: none
};

}  // namespace forge
