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
  std::vector<Vector2> outline;       ///< open ring
  bool is_on_route = false;           ///< belongs to a road of the route
  std::optional<double> speed_limit;  ///< m/s; empty where it is not known
};

/// Relation of a box to the areas of a PdmMap.
struct PdmPlace {
  bool is_in_several_lanes =
      false;                  ///< at least two areas contain a corner, and none contains all four
  bool is_off_road = false;   ///< a corner is off the drivable area
  bool is_wrong_way = false;  ///< no area on the route contains the middle
  std::optional<double>
      speed_limit;  ///< m/s, of the first area on the route that contains the middle
};

/// The map that PDM-Closed scores against: areas, intersections and the drivable area. Global map
/// frame, m.
class PdmMap {
 public:
  /// `intersections`: outlines, open rings. The union of `areas` is the drivable area until
  /// setDrivable() is called.
  PdmMap(const std::vector<PdmArea>& areas, const std::vector<std::vector<Vector2>>& intersections);
  /// Replaces the drivable area by a raster of 0.5 m resolution; corners may be up to `margin`
  /// metres off it. `drivable` must outlive the map; null restores the union of the areas.
  void setDrivable(const AreaRaster* drivable, double margin);
  /// Adds an area that counts as on the route and has no lane and no speed limit: the strip along
  /// the route where it leaves the lanes. `outline` is an open ring.
  void addRoute(const std::vector<Vector2>& outline);

  /// Returns the relation of a box to the areas, the route and the drivable area.
  PdmPlace placeOf(const OrientedBox& box) const;
  /// Returns true if an intersection contains the point.
  bool isInIntersection(const Vector2& point) const;

 private:
  struct Outline {
    Polygon polygon;
    Eigen::AlignedBox2d bounds;
    bool holds(const Vector2& point) const;
  };
  static Outline outlineOf(const std::vector<Vector2>& points);
  struct Area {
    Outline outline;
    bool is_on_route = false;
    std::optional<double> speed_limit;
  };
  bool isOffRaster(const OrientedBox& box) const;

  std::vector<Area> areas_;  // those on the route first
  std::vector<Outline> intersections_;
  std::vector<Outline> routes_;
  const AreaRaster* drivable_ = nullptr;
  double drivable_margin_ = 0.0;
};

}  // namespace forge
