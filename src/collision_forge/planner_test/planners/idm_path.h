#pragma once

#include <cstddef>
#include <vector>

#include "collision_forge/base/geometry/oriented_box.h"
#include "collision_forge/base/geometry/polyline.h"

namespace forge {

/// A path through poses, interpolated as nuPlan's IDM planner does: position and heading are linear
/// over the arc length. The last of several coinciding nodes counts, and the path ends at the last
/// node but one. Nodes far apart get intermediate nodes, so that this loses at most a short piece.
class IdmPath {
 public:
  /// Throws std::invalid_argument for fewer than two distinct nodes, or one that is not finite.
  explicit IdmPath(const std::vector<Pose2>& nodes);

  /// Returns the path's length, m.
  double end() const { return arc_lengths_.back(); }
  /// Returns the arc length (m) of the place nearest to `point`; up to the last node, so it may
  /// exceed end().
  double project(const Vector2& point) const { return line_.project(point).arc_length; }
  /// Returns the pose at `arc_length` m, clamped to [0, end()].
  Pose2 at(double arc_length) const;

  /// The nodes of the constructor, with intermediate nodes and without coinciding ones.
  const std::vector<Pose2>& nodes() const { return nodes_; }
  /// Arc lengths of nodes(), m.
  const std::vector<double>& arcLengths() const { return arc_lengths_; }
  /// Returns the index of the last node at or before `arc_length` (m).
  std::size_t nodeBefore(double arc_length) const;

 private:
  Polyline line_;  // with the last node
  std::vector<Pose2> nodes_;
  std::vector<double> arc_lengths_;
};

/// The corridor of `width` metres around a path, with square ends. Finds which boxes touch its
/// remainder from a given arc length on.
class IdmCorridor {
 public:
  /// `path` must outlive the corridor.
  IdmCorridor(const IdmPath& path, const std::vector<OrientedBox>& other_boxes, double width);

  /// Returns, for each box passed to the constructor, whether it reaches into the corridor between
  /// `arc_length` (m) and the path's end.
  std::vector<bool> touchedFrom(double arc_length) const;

 private:
  struct Obstacle {
    OrientedBox box;
    double radius = 0.0;             // m, of the circle around it
    std::size_t touched_before = 0;  ///< one past the last piece that it touches; 0: touches none
  };

  /// Returns false only if the box is certainly farther than `distance` m from the point.
  static bool isWithin(const Obstacle& obstacle, const Vector2& point, double distance);
  /// Returns the part of the corridor from `from`, extended `before` metres backwards, to a node.
  OrientedBox pieceTo(std::size_t node, const Vector2& from, double before) const;
  /// Returns whether the box touches the corridor at a node or on the piece that starts there.
  bool touchesAfter(std::size_t node, const Obstacle& obstacle) const;
  std::size_t touchedBefore(const Obstacle& obstacle) const;

  const IdmPath& path_;
  double width_;
  std::vector<Obstacle> obstacles_;
};

}  // namespace forge
