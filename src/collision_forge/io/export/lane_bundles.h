#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "collision_forge/base/map/lane_map.h"
#include "collision_forge/io/export/road_course.h"

namespace forge {

/// A lane that may share a road with other lanes. Arc lengths are in m; courses are in the map
/// frame.
struct BundleLane {
  RoadCourse course;        ///< in driving direction; not empty
  double width = 0.0;       ///< m
  bool may_share = false;   ///< false (connectors): the lane stays alone in its bundle
  bool is_entered = false;  ///< another lane leads into its start
  /// The lane is exited: its end leads into another lane (not: on the left side).
  bool is_left = false;
};

/// A lane within a bundle. All arc lengths are measured on the course of the bundle.
struct BundleMember {
  std::size_t lane = 0;  ///< index of the BundleLane in the input of bundlesOf()
  bool along = true;  ///< true: driven in the direction of the bundle's course; false: against it
  /// m, where the lane begins in the direction of the course, whichever way it is driven; may be
  /// negative.
  double from = 0.0;
  double to = 0.0;  ///< m, > from; where the lane ends in that direction
};

/// Lanes side by side that become one road, and the shape of that road.
struct LaneBundle {
  RoadCourse course;  ///< reference line: the course of one of the `along` members
  /// From left to right, seen along the course; the `along` lanes on the driving side.
  std::vector<BundleMember> members;
  /// m, arc length of the course at which the road begins; the course continues straight beyond its
  /// ends.
  double begin = 0.0;
  double end = 0.0;  ///< m, > begin; where it ends
};

/// Lanes as bundles.
struct LaneBundles {
  /// Every lane is in exactly one; sorted by the smallest lane index in each.
  std::vector<LaneBundle> bundles;
  /// Lanes that lie beside another one and still have a road of their own, because they end
  /// elsewhere, bend too sharply or are too close.
  std::size_t unbundled = 0;
};

/// Groups lanes that lie side by side, of one direction or of both. A road covers the stretch that
/// all its lanes with a link at that end have; if no lane has a link there, the road covers all of
/// its lanes. `side`: the driving side of the map. Indices in the result refer to `lanes`.
LaneBundles bundlesOf(const std::vector<BundleLane>& lanes, DrivingSide side);

/// Returns the arc length (m) on a member's lane, whose course is `lane`, at the place beside
/// `arc_length` (m) of the bundle's course: where the lane crosses the line across the course.
/// Returns NaN if there is none.
double besideOf(const LaneBundle& bundle, const BundleMember& member, const RoadCourse& lane,
                double arc_length);

}  // namespace forge
