#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "collision_forge/base/geometry/oriented_box.h"
#include "collision_forge/base/geometry/polygon.h"
#include "collision_forge/base/map/area_raster.h"

namespace forge {

/// A lane or a car park, as an area.
struct PdmArea {
  std::vector<Vector2> outline;       ///< open ring: the first point is not repeated
  bool is_on_route = false;           ///< belongs to a road of the route
  std::optional<double> speed_limit;  ///< m/s; empty where it is not known
};

/// Relation of a box to the areas of a PdmMap. Corners and middle are points of the box.
struct PdmPlace {
  /// At least two areas contain a corner, and no area contains all four.
  bool is_in_several_lanes = false;
  /// A corner is off the drivable area (of a raster: a corner of the shrunk box)
  bool is_off_road = false;
  bool is_wrong_way = false;  ///< no area on the route, addRoute() included, contains the middle
  std::optional<double> speed_limit;  ///< m/s, of the first area on the route that contains the
                                      ///< middle; empty if there is none or its limit is not known
};

/// The map that PDM-Closed scores against: areas, intersections and the drivable area. Global map
/// frame, m.
class PdmMap {
 public:
  /// `areas`: may overlap. `intersections`: outlines, open rings. The union of `areas` (possibly
  /// none: every box is then off the road) is the drivable area until setDrivable() is called.
  PdmMap(const std::vector<PdmArea>& areas, const std::vector<std::vector<Vector2>>& intersections);
  /// Replaces the drivable area by a raster of 0.5 m resolution. The box is shrunk by `margin`
  /// metres on each side before its corners are looked up. `drivable` must outlive the map; null
  /// restores the union of the areas.
  void setDrivable(const AreaRaster* drivable, double margin);
  /// Adds an area that counts as on the route and has no lane and no speed limit: the strip along
  /// the route where it leaves the lanes. `outline` is an open ring.
  void addRoute(const std::vector<Vector2>& outline);

  /// Returns the relation of a box (global map frame) to the areas, the route and the drivable
  /// area.
  PdmPlace placeOf(const OrientedBox& box) const;
  /// Returns true if an intersection contains the point (m, global map frame).
  bool isInIntersection(const Vector2& point) const;

 private:
  /// A polygon with its bounding box.
  struct Outline {
    Polygon polygon;
    Eigen::AlignedBox2d bounds;
    /// Returns whether the polygon contains the point.
    bool holds(const Vector2& point) const;
  };
  /// Returns the outline of an open ring.
  static Outline outlineOf(const std::vector<Vector2>& points);
  /// As PdmArea.
  struct Area {
    Outline outline;
    bool is_on_route = false;
    std::optional<double> speed_limit;
  };
  /// Returns whether a corner of the box, shrunk by drivable_margin_, is off the raster's area.
  bool isOffRaster(const OrientedBox& box) const;

  std::vector<Area> areas_;  // those on the route first
  std::vector<Outline> intersections_;
  std::vector<Outline> routes_;           ///< of addRoute()
  const AreaRaster* drivable_ = nullptr;  ///< null: the union of the areas counts
  double drivable_margin_ = 0.0;          ///< m
};

}  // namespace forge
