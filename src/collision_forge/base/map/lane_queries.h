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

/// A lane on which a pose may be driving.
struct LaneMatch {
  std::size_t lane = 0;           ///< index into LaneMap::lanes
  PolylineProjection projection;  ///< projection of the pose's position on the centreline
  /// The pose's yaw minus the centreline's at the projection, rad (-pi, pi].
  double heading_error = 0.0;
};

/// A path along consecutive lanes.
struct LanePath {
  std::vector<std::size_t> lanes;  ///< indices into LaneMap::lanes, in driving order
  std::vector<Vector2> points;     ///< m, map frame, along the centrelines (points within 0.2 m
                                   ///< are merged); at least two; if `length` is below 1 m,
                                   ///< extended straight by 1 m
  double length = 0.0;             ///< m along the centrelines, without that extension
  Pose2 end;                       ///< pose on the last centreline at `length`
};

/// Spatial index of one map. Built once per map (milliseconds), then read-only: safe to share among
/// threads. Indices of lanes are indices into LaneMap::lanes; positions and poses are in the map
/// frame, m. Queries ignore lanes whose centreline does not have two distinct points.
class LaneIndex {
 public:
  /// Keeps the map alive. Throws std::invalid_argument for a null map, a centreline that is not
  /// finite, an area that extends over more than 200 km, and a centreline longer than 100 km.
  /// Ignores outgoing ids that the map does not have.
  explicit LaneIndex(std::shared_ptr<const LaneMap> map);

  /// Return the map of the constructor; the reference is valid as long as the index.
  const LaneMap& map() const { return *map_; }
  std::shared_ptr<const LaneMap> sharedMap() const { return map_; }

  /// Returns the centreline of a lane; nullopt if it does not have two distinct points. Throws
  /// std::out_of_range for an index beyond the map's lanes.
  const std::optional<Polyline>& centerline(std::size_t lane) const {
    return centerlines_.at(lane);
  }

  /// Returns the indices of the successor lanes, in the order of Lane::outgoing. Throws
  /// std::out_of_range for an index beyond the map's lanes.
  const std::vector<std::size_t>& successors(std::size_t lane) const {
    return successors_.at(lane);
  }

  /// Returns the lanes whose centreline is within `max_distance` (m) and whose heading at the
  /// closest point is within `max_heading` (rad) of the pose's; empty if there is none. A pose
  /// beyond an end of a lane matches, too, if that end is near enough. Sorted by distance (to 1
  /// mm), then by heading error, which separates lanes that overlap before they diverge, then by
  /// index.
  std::vector<LaneMatch> lanesNear(const Pose2& pose, double max_distance,
                                   double max_heading) const;

  /// Returns the indices of the lanes whose centreline is within `radius` (m) of `center`, whatever
  /// their heading, nearest first, then by index; empty if there is none.
  std::vector<std::size_t> lanesWithin(const Vector2& center, double radius) const;

  /// Returns the path ahead from an arc length (m, clamped) on a lane's centreline: along the lane,
  /// then at each end along straightestSuccessor(), cut off after `distance` (m) or where the lanes
  /// end (at most 1000 lanes). A path below 1 m is extended straight by 1 m. Throws
  /// std::invalid_argument for a lane without a centreline.
  Polyline pathAhead(std::size_t lane, double arc_length, double distance) const;

  /// Returns one path or more, at most `max_paths` (values below 1 count as 1), ahead from an arc
  /// length (m, clamped) on a lane's centreline, each as by pathAhead(), over all successors at
  /// each branch: first the path of pathAhead(), then the paths that leave it, nearest branch
  /// first, then the paths that leave these. Throws std::invalid_argument for a lane without a
  /// centreline.
  std::vector<LanePath> pathsAhead(std::size_t lane, double arc_length, double distance,
                                   std::size_t max_paths) const;

  /// Returns the index of the successor that turns least: the one whose heading stays closest to
  /// the heading at the end of `lane` (smallest maximum difference along the successor); the first
  /// of equals in Lane::outgoing. Returns nullopt if no lane with a centreline follows. Throws
  /// std::invalid_argument for a lane without a centreline.
  std::optional<std::size_t> straightestSuccessor(std::size_t lane) const;

  /// Returns the object for fast queries on the centrelines, accurate to 0.25 m.
  const LaneGrid& grid() const { return grid_; }
  /// Returns the object for fast queries on the drivable area, accurate to half a cell of 0.5 m.
  const AreaRaster& drivable() const { return drivable_; }
  /// Returns the object for fast queries on the walkways, accurate to half a cell of 0.5 m.
  const AreaRaster& walkways() const { return walkways_; }

  /// Returns an index of the same map with every lane and the driving side reversed; indices and
  /// ids of lanes stay. Built on the first call (milliseconds), thread-safe; lives as long as this
  /// index.
  const LaneIndex& reversed() const;

  /// Returns the share, 0..1, of the box's area outside the drivable polygons, sampled at the
  /// centres of equal cells of at most 0.25 m. Returns nullopt if the map has no drivable area.
  std::optional<double> offRoadShare(const OrientedBox& box) const;

 private:
  struct Reversed {
    std::once_flag once;
    std::unique_ptr<const LaneIndex> index;
  };

  /// Returns the centreline of a lane; throws std::invalid_argument if it has none.
  const Polyline& existingCenterline(std::size_t lane) const;
  /// Appends a lane to `path`, from arc length `from` on, until the path is `distance` long.
  void extend(LanePath& path, std::size_t lane, double from, double distance) const;

  std::shared_ptr<const LaneMap> map_;
  AreaRaster drivable_;
  AreaRaster walkways_;
  std::vector<std::optional<Polyline>> centerlines_;  // one per lane
  LaneGrid grid_;
  std::vector<std::vector<std::size_t>> successors_;  // one per lane
  std::vector<Eigen::AlignedBox2d> lane_bounds_;      // one per lane, empty without a centreline
  std::vector<Eigen::AlignedBox2d> drivable_bounds_;  // one per drivable polygon
  std::unique_ptr<Reversed> reversed_ = std::make_unique<Reversed>();
};

}  // namespace forge
