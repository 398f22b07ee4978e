#include "collision_forge/planner_test/planners/route_road.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "collision_forge/base/geometry/polygon.h"
#include "collision_forge/base/map/reference_path.h"

namespace forge {
namespace {

/// Returns the nodes of a smooth line, spaced as most of nuPlan's centrelines.
std::vector<Pose2> nodesOf(const Polyline& line) {
  constexpr double kSpacing = 1.0;  // m
  const ReferencePath path(line);
  const int count = std::max(1, static_cast<int>(std::ceil(path.length() / kSpacing)));
  std::vector<Pose2> nodes;
  for (int i = 0; i <= count; ++i) nodes.push_back(path.at(path.length() * i / count).pose);
  return nodes;
}

/// Returns the indices of the lanes that belong to the route's roads.
std::set<std::size_t> lanesOnRoute(const LaneIndex& lanes, const std::vector<Pose2>& route,
                                   const PdmMapOptions& options) {
  std::set<std::size_t> found;
  for (const Pose2& place : route) {
    for (const LaneMatch& match :
         lanes.lanesNear(place, options.road_half_width, options.road_heading)) {
      found.insert(match.lane);
    }
  }
  return found;
}

/// Returns the lanes around the route; a lane without an outline becomes a strip along its
/// centreline. Where the route leaves the lanes, a strip along it is on the route as well.
PdmMap mapAlong(const LaneIndex& lanes, const std::vector<Pose2>& route,
                const PdmMapOptions& options) {
  const std::set<std::size_t> on_route = lanesOnRoute(lanes, route, options);
  std::set<std::size_t> around;
  const auto stride = static_cast<std::size_t>(std::max(1.0, options.radius));
  for (std::size_t i = 0; i < route.size(); i += stride) {
    for (const std::size_t lane : lanes.lanesWithin(route[i].position(), options.radius)) {
      around.insert(lane);
    }
  }
  std::vector<PdmArea> areas;
  std::vector<std::vector<Vector2>> intersections;
  for (const std::size_t index : around) {
    const Lane& lane = lanes.map().lanes[index];
    std::vector<Vector2> outline =
        lane.polygon.size() >= 3 ? lane.polygon : stripAlong(lane.centerline, options.lane_width);
    if (lane.is_connector || lane.is_intersection) intersections.push_back(outline);
    areas.push_back({std::move(outline), on_route.count(index) > 0, lane.speed_limit});
  }
  PdmMap map(areas, intersections);
  map.addRoute(stripAlong(route, options.lane_width));
  if (!lanes.drivable().empty()) map.setDrivable(&lanes.drivable(), options.drivable_margin);
  return map;
}

}  // namespace

RouteRoad roadAlong(const LaneIndex& lanes, const std::vector<Vector2>& route,
                    const RouteCenterlineOptions& centerline, const PdmMapOptions& options) {
  std::vector<Pose2> nodes = nodesOf(routeCenterline(lanes, route, centerline));
  PdmMap map = mapAlong(lanes, nodes, options);
  return {std::move(nodes), std::move(map)};
}

}  // namespace forge
