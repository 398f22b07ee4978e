#include "collision_forge/planner_test/planners/pdm_map.h"

#include <algorithm>
#include <array>

namespace forge {

PdmMap::PdmMap(const std::vector<PdmArea>& areas,
               const std::vector<std::vector<Vector2>>& intersections) {
  for (const PdmArea& area : areas) {
    areas_.push_back({outlineOf(area.outline), area.is_on_route, area.speed_limit});
  }
  std::stable_partition(areas_.begin(), areas_.end(),
                        [](const Area& area) { return area.is_on_route; });
  for (const auto& outline : intersections) intersections_.push_back(outlineOf(outline));
}

void PdmMap::setDrivable(const AreaRaster* drivable, double margin) {
  drivable_ = drivable;
  drivable_margin_ = margin;
}

void PdmMap::addRoute(const std::vector<Vector2>& outline) {
  routes_.push_back(outlineOf(outline));
}

PdmPlace PdmMap::placeOf(const OrientedBox& box) const {
  const std::array<Vector2, 4> outline = corners(box);
  const Eigen::AlignedBox2d bounds = [&] {
    Eigen::AlignedBox2d around(outline[0]);
    for (const Vector2& corner : outline) around.extend(corner);
    return around;
  }();
  std::array<bool, 4> is_on_road{};
  int touched = 0;
  bool is_in_one = false;
  const Vector2 middle = box.center.position();
  const bool is_on_route = std::any_of(routes_.begin(), routes_.end(),
                                       [&](const Outline& route) { return route.holds(middle); });
  bool is_in_lane_on_route = false;
  std::optional<double> speed_limit;
  for (const Area& area : areas_) {
    if (!area.outline.bounds.intersects(bounds)) continue;
    int inside = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      if (!area.outline.holds(outline[i])) continue;
      is_on_road[i] = true;
      ++inside;
    }
    touched += inside > 0;
    is_in_one = is_in_one || inside == 4;
    if (!is_in_lane_on_route && area.is_on_route && area.outline.holds(middle)) {
      is_in_lane_on_route = true;
      speed_limit = area.speed_limit;
    }
    if (is_in_one && is_in_lane_on_route) break;  // no other area can change the result
  }
  const bool is_all_on_road = is_in_one || std::all_of(is_on_road.begin(), is_on_road.end(),
                                                       [](bool is_on) { return is_on; });
  return {touched > 1 && !is_in_one, drivable_ ? isOffRaster(box) : !is_all_on_road,
          !is_on_route && !is_in_lane_on_route, speed_limit};
}

bool PdmMap::isInIntersection(const Vector2& point) const {
  return std::any_of(intersections_.begin(), intersections_.end(),
                     [&](const Outline& outline) { return outline.holds(point); });
}

bool PdmMap::Outline::holds(const Vector2& point) const {
  return bounds.contains(point) && contains(polygon, point);
}

PdmMap::Outline PdmMap::outlineOf(const std::vector<Vector2>& points) {
  Outline outline{{points, {}}, {}};
  for (const Vector2& point : points) outline.bounds.extend(point);
  return outline;
}

bool PdmMap::isOffRaster(const OrientedBox& box) const {
  const std::array<Vector2, 4> outline = corners(shrunk(box, drivable_margin_));
  return !std::all_of(outline.begin(), outline.end(),
                      [&](const Vector2& corner) { return drivable_->contains(corner); });
}

}  // namespace forge
