#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "collision_forge/map/lane_queries.h"

namespace forge {

/// The areas of the lanes around a place, for questions about the ego's surroundings. Lanes without
/// an outline are left out. The index must outlive it.
class LaneAreas {
 public:
  /// Of the lanes whose centreline comes within `radius` metres of `center`.
  LaneAreas(const LaneIndex& lanes, const Vector2& center, double radius);

  /// True when the box is within no one lane and its corners are in two or more.
  bool inSeveralLanes(const OrientedBox& box) const;

  /// True when the pose's position is in a lane, and in none whose centreline there heads within 90
  /// degrees of the pose.
  bool isOncoming(const Pose2& pose) const;

 private:
  struct Area {
    std::size_t lane = 0;
    Polygon outline;
    Eigen::AlignedBox2d bounds;
  };
  static bool isIn(const Area& area, const Vector2& point);

  const LaneIndex& lanes_;
  std::vector<Area> areas_;
};

}  // namespace forge
