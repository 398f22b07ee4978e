#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "collision_forge/base/map/lane_map.h"
#include "collision_forge/io/export/road_course.h"

namespace forge {

/// A lane that may share a road with others.
struct BundleLane {
  RoadCourse course;        ///< in driving direction; not empty
  double width = 0.0;       ///< m
  bool may_share = false;   ///< false: the lane stays alone
  bool is_entered = false;  ///< another lane leads into its start
  bool is_left = false;     ///< its end leads into another lane
};

/// A lane within a bundle. All arc lengths are measured on the course of the bundle.
struct BundleMember {
  std::size_t lane = 0;  ///< index of the BundleLane
  bool along = true;     ///< driven in the direction of the bundle's course
  double from = 0.0;     ///< m, where the lane begins in the direction of the course
  double to = 0.0;       ///< m, where it ends
};

/// Lanes side by side that become one road, and the shape of that road.
struct LaneBundle {
  RoadCourse course;                  ///< reference line, in driving direction of the `along` lanes
  std::vector<BundleMember> members;  ///< from left to right; the `along` lanes on the driving side
  double begin = 0.0;                 ///< m, arc length of the course at which the road begins
  double end = 0.0;                   ///< m, > begin; where it ends
};

/// Lanes as bundles.
struct LaneBundles {
  std::vector<LaneBundle> bundles;  ///< every lane is in exactly one
  /// Lanes that lie beside another one and still have a road of their own, because they end
  /// elsewhere, bend too sharply or are too close.
  std::size_t unbundled = 0;
};

/// Groups lanes that lie side by side, of one direction or of both.
/// A road covers the part that all its lanes with a link at that end have; where none has one, it
/// covers all of them.
LaneBundles bundlesOf(const std::vector<BundleLane>& lanes, DrivingSide side);

/// Returns the arc length (m) on a member's lane beside an arc length (m) of the bundle's course;
/// NaN if there is none.
double besideOf(const LaneBundle& bundle, const BundleMember& member, const RoadCourse& lane,
                double arc_length);

}  // namespace forge
