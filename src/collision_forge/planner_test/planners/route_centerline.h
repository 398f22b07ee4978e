#pragma once

#include <vector>

#include "collision_forge/base/geometry/polyline.h"
#include "collision_forge/base/map/lane_queries.h"

namespace forge {

/// Options of routeCenterline() and laneRoute(); used by IDM and PDM-Closed.
struct RouteCenterlineOptions {
  double spacing = 2.0;  ///< m between the places of the route at which lanes are searched
  /// m from the route to a lane's centreline, at most; lanes farther away are ignored.
  double route_lane_distance = 4.0;
  double route_lane_heading = 0.8;  ///< rad between the directions of the route and a lane, at most
  double lane_change_cost = 20.0;  ///< m; cost of a change between lanes that are not connected, in
                                   ///< summed distance from the centreline
  double off_lane_cost = 5.0;      ///< m; cost of a place of the route without a lane
  double lane_change_length = 20.0;  ///< m over which a lane change is smoothed
};

/// Returns the lane centrelines along `route` (m, global map frame) as one line. Chooses, by a
/// shortest path over the places of the route, connected lanes with the least summed distance to it
/// plus the costs of the options. The line begins and ends beside the ends of the route. Lane
/// changes are smoothed over `lane_change_length` metres; without a lane nearby, uses the route
/// itself. Throws std::invalid_argument for a route without two distinct points.
Polyline routeCenterline(const LaneIndex& lanes, const std::vector<Vector2>& route,
                         const RouteCenterlineOptions& options);

}  // namespace forge
