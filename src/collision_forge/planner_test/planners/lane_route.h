#pragma once

#include <cstddef>
#include <vector>

#include "collision_forge/base/map/lane_queries.h"
#include "collision_forge/planner_test/planners/route_centerline.h"

namespace forge {

/// Returns the lanes (indices in lanes.map().lanes, in driving order) that nuPlan's IDM planner
/// would follow along a route. Starts at the lane that contains `start` (middle of the ego's box;
/// else the nearest) and continues over successors near the route, without lane changes, to the one
/// that accompanies the route farthest; of equal ones, to the one nearest to the route there, over
/// the fewest lanes. The result contains the first and the last lane whole. `route` and `start`: m,
/// global map frame. Empty if no lane along the route is near `start`. Throws std::invalid_argument
/// for a route without two distinct points.
std::vector<std::size_t> laneRoute(const LaneIndex& lanes, const std::vector<Vector2>& route,
                                   const Pose2& start, const RouteCenterlineOptions& options);

}  // namespace forge
