#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include "collision_forge/base/geometry/arc_path.h"
#include "collision_forge/base/map/lane_map.h"

namespace forge {

/// Arcs of lanes by lane id, in driving direction; empty for maps that have points only.
using LaneArcs = std::unordered_map<std::string, std::vector<ArcPath>>;

/// A piece of a road's reference line: a line if the curvature is 0, else an arc.
struct RoadPiece {
  Pose2 start;          ///< at the beginning of the piece, map frame, heading in driving direction
  double length = 0.0;  ///< m, > 0
  double curvature = 0.0;  ///< 1/m, positive to the left
};

/// A chain of lines and arcs with arc lengths from 0 to length(), in driving direction of a lane,
/// in the map frame.
class RoadCourse {
 public:
  RoadCourse() = default;
  /// Each piece should begin at the end of the one before; not checked.
  explicit RoadCourse(std::vector<RoadPiece> pieces);

  const std::vector<RoadPiece>& pieces() const { return pieces_; }
  /// Returns true if there is no piece.
  bool empty() const { return pieces_.empty(); }
  /// Returns the sum of the pieces' lengths, m.
  double length() const { return length_; }

  /// Returns the pose at an arc length (m). Beyond either end the course continues straight. There
  /// must be a piece.
  Pose2 poseAt(double arc_length) const;

  /// Returns the part from one arc length (m) to a larger one, extended by straight lines beyond
  /// the ends; empty if it is shorter than 1 micrometre or `to` <= `from`. There must be a piece.
  RoadCourse between(double from, double to) const;

  /// Returns the arc length (m) at which the course crosses the line through `pose` across its
  /// heading, searched from `guess` (m) by Newton's method; beyond the ends on their extensions.
  /// Returns NaN if the search does not settle or the course runs nearly (to 6 degrees) parallel to
  /// that line. There must be a piece.
  double crossing(const Pose2& pose, double guess) const;

  /// Returns the arc length (m) at which `point` lies straight to the side, searched from `guess`
  /// (m); beyond the ends on their extensions. NaN if the search does not settle. There must be a
  /// piece.
  double projection(const Vector2& point, double guess) const;

  /// Returns the arc length (m, within the course) of the point nearest to `point`, to 1 m, as a
  /// guess for the searches above. There must be a piece.
  double roughProjection(const Vector2& point) const;

  /// Appends the pieces of another course, unmoved; it should begin where this one ends.
  void append(const RoadCourse& other);

 private:
  std::vector<RoadPiece> pieces_;
  std::vector<double> begins_;  // m, arc length at which each piece begins
  double length_ = 0.0;         ///< m
};

/// Returns the course of a lane: its arcs, or, if `arcs` has none for it, arcs that leave each pose
/// of the centreline along its heading and end at the next one. Empty for a lane shorter than 5 cm.
RoadCourse courseOf(const Lane& lane, const LaneArcs& arcs);

/// Returns the mean lane width in m: the outline's area over `length` (m, of the lane), clamped to
/// 2 to 8 m; `otherwise` (m) if there is no outline or `length` is not positive.
double widthOf(const Lane& lane, double length, double otherwise);

}  // namespace forge
