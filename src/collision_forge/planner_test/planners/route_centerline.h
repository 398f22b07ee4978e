#pragma once

#include <vector>

#include "collision_forge/base/geometry/polyline.h"
#include "collision_forge/base/map/lane_queries.h"

namespace forge {

/// How the lane centrelines along a route are found, which IDM and PDM-Closed follow.
struct RouteCenterlineOptions {
  double spacing = 2.0;  ///< m between the places of the route that lanes are looked for
  double route_lane_distance = 4.0;  ///< m; lanes farther from the route, about one beside, are off
  double route_lane_heading = 0.8;   ///< rad between the route and a lane
  double lane_change_cost = 20.0;    ///< m; worth as much distance from the centreline, summed
  double off_lane_cost = 5.0;        ///< m; the same for a place on no lane
  double lane_change_length = 20.0;  ///< m over which a change of lanes is smoothed
};

/// The lane centrelines along a route: of the lanes near each place of the route, those that follow
/// each other and are nearest to it on the whole (a shortest path over the places); where the route
/// changes lanes, passing over in `lane_change_length` metres; where no lane is near, the route
/// itself. Throws std::invalid_argument for a route without two distinct points.
Polyline routeCenterline(const LaneIndex& lanes, const std::vector<Vector2>& route,
                         const RouteCenterlineOptions& options);

}  // namespace forge
