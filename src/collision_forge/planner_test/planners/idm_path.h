#pragma once

#include <cstddef>
#include <vector>

#include "collision_forge/base/geometry/oriented_box.h"
#include "collision_forge/base/geometry/polyline.h"

namespace forge {

/// A path through poses in the global map frame, interpolated as nuPlan's IDM planner does:
/// position and heading are linear over the arc length. The last of several coinciding nodes
/// counts, and the path ends at the last node but one. Nodes more than 20 m apart get intermediate
/// nodes at equal distances, so that this loses at most 20 m; two nodes within 20 m give a path of
/// length 0.
class IdmPath {
 public:
  /// `nodes`: in driving order. Throws std::invalid_argument for fewer than two distinct nodes, or
  /// one that is not finite.
  explicit IdmPath(const std::vector<Pose2>& nodes);

  /// Returns the path's length, m.
  double end() const { return arc_lengths_.back(); }
  /// Returns the arc length (m) of the place on the path nearest to `point` (m, global map frame).
  /// The last node of the constructor counts, so the result may exceed end().
  double project(const Vector2& point) const { return line_.project(point).arc_length; }
  /// Returns the pose at `arc_length` (m from the first node), clamped to [0, end()].
  Pose2 at(double arc_length) const;

  /// Returns the nodes of the constructor, with intermediate nodes and without coinciding ones and
  /// the last; at least one.
  const std::vector<Pose2>& nodes() const { return nodes_; }
  /// Returns the arc length of each of nodes(), m, ascending from 0.
  const std::vector<double>& arcLengths() const { return arc_lengths_; }
  /// Returns the index in nodes() of the last node at or before `arc_length` (m): 0 for a negative
  /// one, the last index from end() on.
  std::size_t nodeBefore(double arc_length) const;

 private:
  Polyline line_;  ///< through all nodes, also the last one
  std::vector<Pose2> nodes_;
  std::vector<double> arc_lengths_;
};

/// The corridor of `width` metres around a path, half of it on either side, with square ends. Finds
/// which boxes touch its remainder from a given arc length on.
class IdmCorridor {
 public:
  /// `other_boxes`: global map frame; `width`: m. Keeps a reference to `path`, which must outlive
  /// the corridor.
  IdmCorridor(const IdmPath& path, const std::vector<OrientedBox>& other_boxes, double width);

  /// Returns, for each box of the constructor in its order, whether it reaches into the corridor
  /// between `arc_length` (m, in [0, path.end()]) and the path's end. All are false at the path's
  /// end.
  std::vector<bool> touchedFrom(double arc_length) const;

 private:
  /// A box of the constructor, prepared for the search.
  struct Obstacle {
    OrientedBox box;                 ///< global map frame
    double radius = 0.0;             ///< m, of the circle around it
    std::size_t touched_before = 0;  ///< one past the last piece that it touches; 0: touches none
  };

  /// Returns false only if the box is certainly farther than `distance` m from the point.
  static bool isWithin(const Obstacle& obstacle, const Vector2& point, double distance);
  /// Returns the part of the corridor from `from`, extended `before` metres backwards, to a node.
  OrientedBox pieceTo(std::size_t node, const Vector2& from, double before) const;
  /// Returns whether the box touches the corridor at a node or on the piece that starts there.
  bool touchesAfter(std::size_t node, const Obstacle& obstacle) const;
  /// Returns Obstacle::touched_before of an obstacle.
  std::size_t touchedBefore(const Obstacle& obstacle) const;

  const IdmPath& path_;
  double width_;
  std::vector<Obstacle> obstacles_;
};

}  // namespace forge
