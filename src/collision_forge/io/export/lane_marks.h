#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "collision_forge/base/map/lane_map.h"
#include "collision_forge/io/export/road_course.h"

namespace forge {

/// A mark along a border of a lane.
struct LaneMark {
  double from = 0.0;  ///< m, arc length at which it begins; it ends where the next one begins
  std::optional<FeatureKind> line;  ///< the painted line of the map; empty: the map has none here
};

/// The painted lines of a map, for the marks of its roads.
class PaintedLines {
 public:
  /// Keeps references to the features of `map`, which must outlive the object.
  explicit PaintedLines(const LaneMap& map);

  /// Returns the marks along a border between two arc lengths of `course`, from `begin` on, one or
  /// more. `border` returns the distance (m, positive to the left) from the course to the border at
  /// an arc length. A line counts as the border's where it is at most 0.5 m away and parallel to
  /// 0.2 rad.
  std::vector<LaneMark> marksAlong(const RoadCourse& course,
                                   const std::function<double(double)>& border, double begin,
                                   double end) const;

 private:
  struct Line {
    FeatureKind kind;
    const std::vector<Vector2>* points;
    Vector2 low;  // corners of the box around it
    Vector2 high;
  };

  std::optional<FeatureKind> nearestTo(const Pose2& place) const;

  std::vector<Line> lines_;
};

}  // namespace forge
