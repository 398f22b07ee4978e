#pragma once

#include <cstddef>
#include <vector>

#include "collision_forge/base/geometry/oriented_box.h"
#include "collision_forge/base/geometry/polyline.h"

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
  /// Of the nodes, m.
  const std::vector<double>& arcLengths() const { return arc_lengths_; }
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

  /// One an other: true when it reaches into the corridor from `arc_length` to the path's end.
  std::vector<bool> touchedFrom(double arc_length) const;

 private:
  struct Other {
    OrientedBox box;
    double radius = 0.0;             // m, of the circle around it
    std::size_t touched_before = 0;  // the node after the last piece that it touches; 0: none
  };

  /// False only where the box is surely farther from the point.
  static bool isWithin(const Other& other, const Vector2& point, double distance);
  /// The corridor's ground from a place of the path, and `before` metres behind it, to a node.
  OrientedBox pieceTo(std::size_t node, const Vector2& from, double before) const;
  /// True when the other touches the corridor at a node or on the piece that begins there.
  bool touchesAfter(std::size_t node, const Other& other) const;
  std::size_t touchedBefore(const Other& other) const;

  const IdmPath& path_;
  double width_;
  std::vector<Other> others_;
};

}  // namespace forge
