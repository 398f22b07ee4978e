#pragma once

#include <vector>

#include "collision_forge/base/geometry/polyline.h"
#include "collision_forge/base/map/lane_queries.h"

namespace forge {

/// config/planners.yaml, section route_centerline, where each number's unit and source stand.
struct RouteCenterlineOptions {
  double spacing = 0.0;
  double route_lane_distance = 0.0;
  double route_lane_heading = 0.0;
  double lane_change_cost = 0.0;
  double off_lane_cost = 0.0;
  double lane_change_length = 0.0;
};

/// The lane centrelines along a route: of the lanes near each place of the route, those that follow
/// each other and are nearest to it on the whole (a shortest path over the places); where the route
/// changes lanes, passing over in `lane_change_length` metres; where no lane is near, the route
/// itself. Throws std::invalid_argument for a route without two distinct points.
Polyline routeCenterline(const LaneIndex& lanes, const std::vector<Vector2>& route,
                         const RouteCenterlineOptions& options);

}  // namespace forge
