#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "collision_forge/base/geometry/polyline.h"
#include "collision_forge/base/map/area_raster.h"
#include "collision_forge/base/map/lane_grid.h"
#include "collision_forge/base/map/lane_map.h"

namespace forge {

/// A lane that a pose may be driving on.
struct LaneMatch {
  std::size_t lane = 0;           ///< index into LaneMap::lanes
  PolylineProjection projection;  ///< of the pose's position on the centreline
  double heading_error = 0.0;     ///< the pose's yaw minus the centreline's, radians (-pi, pi]
};

/// A way ahead through the lanes.
struct LanePath {
  std::vector<std::size_t> lanes;  ///< indices into LaneMap::lanes, in driving order
  std::vector<Vector2> points;     ///< of the centrelines, at least two and a metre in all
  double length = 0.0;             ///< metres along the centrelines
  Pose2 end;                       ///< on the last centreline
};

/// Answers questions of place about one map. Built once a map (milliseconds), then read-only: safe
/// to share among threads. Lanes whose centreline has no two distinct points are never found.
class LaneIndex {
 public:
  /// Throws std::invalid_argument without a map, for a centreline that is not finite, and for an
  /// area or a centreline beyond 100 km. Outgoing ids that the map does not have are ignored.
  explicit LaneIndex(std::shared_ptr<const LaneMap> map);

  const LaneMap& map() const { return *map_; }
  std::shared_ptr<const LaneMap> sharedMap() const { return map_; }

  /// Empty when the lane has no centreline.
  const std::optional<Polyline>& centerline(std::size_t lane) const {
    return centerlines_.at(lane);
  }

  /// Indices of the lanes that follow, in the order of Lane::outgoing.
  const std::vector<std::size_t>& successors(std::size_t lane) const {
    return successors_.at(lane);
  }

  /// Lanes whose centreline is at most `max_distance` metres away and along which the pose heads
  /// within `max_heading` radians. Sorted by distance to the millimetre, then by heading error (so
  /// lanes that share a stretch before they part are told apart by heading), then by index.
  std::vector<LaneMatch> lanesNear(const Pose2& pose, double max_distance,
                                   double max_heading) const;

  /// Lanes whose centreline comes within `radius` metres, nearest first, then by index.
  std::vector<std::size_t> lanesWithin(const Vector2& center, double radius) const;

  /// The way ahead from an arc length on a lane's centreline (clamped to it): on along the lane,
  /// then at each end along straightestSuccessor(), for `distance` metres or until the lanes end;
  /// Polyline::poseAt goes straight on from there. At least a metre long, straight if need be.
  /// Throws std::invalid_argument for a lane without a centreline.
  Polyline pathAhead(std::size_t lane, double arc_length, double distance) const;

  /// The ways ahead from an arc length on a lane's centreline (clamped to it) with all successors
  /// at each branch, as many as `max_paths` at most: first the one that pathAhead() takes, then
  /// those that leave it, nearest first, then those that leave these. Throws std::invalid_argument
  /// for a lane without a centreline.
  std::vector<LanePath> pathsAhead(std::size_t lane, double arc_length, double distance,
                                   std::size_t max_paths) const;

  /// The following lane that turns least: its heading's largest difference, anywhere along it, from
  /// the heading at the end of `lane` is smallest; the first in Lane::outgoing of equals. Empty at
  /// the end of the lanes. Throws std::invalid_argument for a lane without a centreline.
  std::optional<std::size_t> straightestSuccessor(std::size_t lane) const;

  /// The centrelines, quickly and to half a metre.
  const LaneGrid& grid() const { return grid_; }
  /// The drivable area, quickly and to half a metre.
  const AreaRaster& drivable() const { return drivable_; }
  /// The same of the walkways.
  const AreaRaster& walkways() const { return walkways_; }

  /// The same map with every lane driven the other way, which turns the driving side round, too.
  /// Made when it is first asked for (milliseconds); lives as long as this one.
  const LaneIndex& reversed() const;

  /// Share of the box's area off the union of the drivable polygons, in [0, 1], told from the
  /// middles of equal cells at most 0.25 m long and wide. Empty (unknown) when the map has no
  /// drivable area.
  std::optional<double> offRoadShare(const OrientedBox& box) const;

 private:
  struct Reversed {
    std::once_flag once;
    std::unique_ptr<const LaneIndex> index;
  };

  const Polyline& existingCenterline(std::size_t lane) const;
  void extend(LanePath& path, std::size_t lane, double from, double distance) const;

  std::shared_ptr<const LaneMap> map_;
  AreaRaster drivable_;
  AreaRaster walkways_;
  std::vector<std::optional<Polyline>> centerlines_;  // one a lane
  LaneGrid grid_;
  std::vector<std::vector<std::size_t>> successors_;  // one a lane
  std::vector<Eigen::AlignedBox2d> lane_bounds_;      // one a lane, empty without a centreline
  std::vector<Eigen::AlignedBox2d> drivable_bounds_;  // one a drivable polygon
  std::unique_ptr<Reversed> reversed_ = std::make_unique<Reversed>();
};

}  // namespace forge
