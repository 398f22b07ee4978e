#pragma once

#include <vector>

#include "collision_forge/base/map/lane_queries.h"
#include "collision_forge/planner_test/planners/pdm_map.h"
#include "collision_forge/planner_test/planners/pdm_options.h"
#include "collision_forge/planner_test/planners/route_centerline.h"

namespace forge {

/// The road along a route: what nuPlan's maps know of theirs, told from a map of lanes.
struct RouteRoad {
  std::vector<Pose2> nodes;  ///< of its smooth centreline (routeCenterline()), about a metre apart
  PdmMap map;                ///< must not outlive the lanes
};

/// Throws std::invalid_argument for a route without two distinct points.
RouteRoad roadAlong(const LaneIndex& lanes, const std::vector<Vector2>& route,
                    const RouteCenterlineOptions& centerline, const PdmMapOptions& options);

}  // namespace forge
