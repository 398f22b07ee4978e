#pragma once

#include <vector>

#include "collision_forge/base/map/lane_queries.h"
#include "collision_forge/planner_test/planners/pdm_map.h"
#include "collision_forge/planner_test/planners/pdm_options.h"
#include "collision_forge/planner_test/planners/route_centerline.h"

namespace forge {

/// The road along a route in the form of nuPlan's maps, derived from a map of lanes.
struct RouteRoad {
  std::vector<Pose2> nodes;  ///< of the smoothed routeCenterline(), in driving order, about 1 m
                             ///< apart; global map frame
  PdmMap map;  ///< lanes within PdmMapOptions::radius of the nodes, with the drivable area of the
               ///< lane map if that has one; the `lanes` of roadAlong() must outlive it
};

/// Builds the road along `route` (m, global map frame). `centerline`: how its lanes are found;
/// `options`: how roads are derived from lanes. Throws std::invalid_argument for a route without
/// two distinct points.
RouteRoad roadAlong(const LaneIndex& lanes, const std::vector<Vector2>& route,
                    const RouteCenterlineOptions& centerline, const PdmMapOptions& options);

}  // namespace forge
