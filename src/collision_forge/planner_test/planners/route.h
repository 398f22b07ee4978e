#pragma once

#include <vector>

#include "collision_forge/base/map/lane_queries.h"
#include "collision_forge/base/scene/track.h"

namespace forge {

/// config/planners.yaml, section planning, where each number's unit and source stand.
struct RouteOptions {
  double spacing = 0.0;
  double length_ahead = 0.0;
  double join_distance = 0.0;
  double end_lane_distance = 0.0;
  double end_lane_heading = 0.0;
};

/// The way that a recorded ego is meant to take: its recorded positions at least `spacing` apart,
/// then for `length_ahead` metres along the lanes (LaneIndex::pathAhead() of the lane nearest to
/// its last pose, joined `join_distance` metres ahead; straight on off the lanes). At least two
/// points. Throws std::invalid_argument for a track without states.
std::vector<Vector2> routeOf(const Track& recorded, const LaneIndex& lanes,
                             const RouteOptions& options);

}  // namespace forge
