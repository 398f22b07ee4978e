#pragma once

#include <vector>

#include "collision_forge/base/map/lane_queries.h"
#include "collision_forge/base/scene/track.h"

namespace forge {

/// Options of routeOf().
struct RouteOptions {
  double spacing = 1.0;         ///< m between two recorded positions of the route, at least
  double length_ahead = 100.0;  ///< m of route along lanes after the recording: 8 s at 12.5 m/s
  /// m ahead of the recording's last pose at which the route joins these lanes.
  double join_distance = 5.0;
  double end_lane_distance = 3.0;  ///< m from the recording's last pose to a lane, at most
  /// rad (45 degrees) between that pose and the lane's direction, at most.
  double end_lane_heading = 0.785;
};

/// Returns the path that a recorded ego should follow (m, global map frame): its recorded positions
/// at least `spacing` apart, then `length_ahead` metres along LaneIndex::pathAhead() of the lane
/// nearest to its last pose, joined at their first point at least `join_distance` metres ahead;
/// straight ahead where no lane is and where lanes end early. Has at least two points; a recording
/// that hardly moves gives its first position and the path ahead. Throws std::invalid_argument for
/// a track without states.
std::vector<Vector2> routeOf(const Track& recorded, const LaneIndex& lanes,
                             const RouteOptions& options);

}  // namespace forge
