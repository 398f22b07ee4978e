#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "collision_forge/base/geometry/oriented_box.h"
#include "collision_forge/base/geometry/polygon.h"
#include "collision_forge/base/map/area_raster.h"

namespace forge {

/// A lane or a car park.
struct PdmArea {
  std::vector<Vector2> outline;       ///< open ring
  bool is_on_route = false;           ///< of a road that the route takes
  std::optional<double> speed_limit;  ///< m/s; empty where it is not known
};

/// Where a box is.
struct PdmPlace {
  bool is_in_several_lanes = false;   ///< two areas hold a corner, and none holds all four
  bool is_off_road = false;           ///< a corner is off the drivable area
  bool is_wrong_way = false;          ///< the middle is in no area on the route
  std::optional<double> speed_limit;  ///< m/s, of the first area on the route that holds the middle
};

/// The ground around the ego as PDM-Closed sees it. Global map frame.
class PdmMap {
 public:
  /// The areas together are the drivable area.
  PdmMap(const std::vector<PdmArea>& areas, const std::vector<std::vector<Vector2>>& intersections);
  /// `drivable` is the drivable area instead, known to half a metre: corners may be off it by
  /// `margin` metres. It must outlive the map; null is as above.
  void setDrivable(const AreaRaster* drivable, double margin);
  /// Adds an outline that is no lane but on the route.
  void addRoute(const std::vector<Vector2>& outline);

  PdmPlace placeOf(const OrientedBox& box) const;
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
