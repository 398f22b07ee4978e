#pragma once

#include <vector>

#include "collision_forge/base/map/lane_queries.h"
#include "collision_forge/base/scene/track.h"

namespace forge {

/// The way that the ego is meant to take: its recording, then lanes.
struct RouteOptions {
  double spacing = 1.0;             ///< m between its points, at least
  double length_ahead = 100.0;      ///< m along lanes after the recording: 8 s at 12.5 m/s
  double join_distance = 5.0;       ///< m after the recording's end that these lanes are joined at
  double end_lane_distance = 3.0;   ///< m from the recording's end to a lane
  double end_lane_heading = 0.785;  ///< rad (45 degrees) between both
};

/// The way that a recorded ego is meant to take: its recorded positions at least `spacing` apart,
/// then for `length_ahead` metres along the lanes (LaneIndex::pathAhead() of the lane nearest to
/// its last pose, joined `join_distance` metres ahead; straight on off the lanes). At least two
/// points. Throws std::invalid_argument for a track without states.
std::vector<Vector2> routeOf(const Track& recorded, const LaneIndex& lanes,
                             const RouteOptions& options);

}  // namespace forge
