#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "collision_forge/base/map/lane_map.h"
#include "collision_forge/io/export/road_network.h"

namespace forge {

/// A walkway along one side of a road. Gap and width are linear between the arc lengths.
struct Sidewalk {
  std::vector<double> at;        ///< m, arc lengths of the road, ascending, from 0 to its length
  std::vector<double> gap;       ///< m, from the border of the outermost lane to the walkway
  std::vector<double> width;     ///< m; 0 where there is no walkway
  bool is_gap_drivable = false;  ///< most of the gap is drivable area
};

/// Finds the walkways along roads.
class SidewalkFinder {
 public:
  /// Keeps a reference to `map`, which must outlive the object.
  explicit SidewalkFinder(const LaneMap& map);

  /// Returns the walkway along the left (`side` 1) or right (-1) of a road: one that begins at most
  /// 3 m beside the outermost lane, along at least 70 % of the road. Empty `at`: there is none, or
  /// the road is in a junction. Wider walkways are cut at 5 m.
  Sidewalk along(const Road& road, int side) const;

 private:
  /// The part of a walkway on a straight line outwards from a border, m from the border.
  struct Crossing {
    double from = 0.0;
    double to = 0.0;
  };

  static std::optional<Crossing> crossingOf(const Polygon& polygon, const Vector2& start,
                                            const Vector2& direction);
  std::optional<Crossing> nearestCrossing(const Vector2& start, const Vector2& direction) const;
  bool isDrivable(const Vector2& place) const;

  const LaneMap& map_;
  std::vector<Eigen::AlignedBox2d> boxes_;  // around each walkway
};

}  // namespace forge
