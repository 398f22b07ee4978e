#pragma once

#include <cstddef>
#include <vector>

#include "collision_forge/base/map/lane_queries.h"
#include "collision_forge/planner_test/planners/route_centerline.h"

namespace forge {

/// The lanes that nuPlan's IDM planner would take along a route: from the one that holds `start`
/// (the nearest where none does) on to lanes that follow and come near the route, without a change
/// of lanes, to where the route gets farthest; of several such ways the one of fewest lanes. Empty
/// where no lane along the route is near `start`. Throws std::invalid_argument for a route without
/// two distinct points.
std::vector<std::size_t> laneRoute(const LaneIndex& lanes, const std::vector<Vector2>& route,
                                   const Pose2& start, const RouteCenterlineOptions& options);

}  // namespace forge
