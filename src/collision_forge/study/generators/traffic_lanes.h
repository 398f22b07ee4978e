#pragma once

#include <vector>

#include "collision_forge/base/map/lane_queries.h"
#include "collision_forge/study/generators/options.h"

namespace forge {

/// A piece of a lane's centreline, in driving direction.
struct TrafficLane {
  std::vector<Pose2> points;     ///< two at least, TrafficLaneOptions::spacing apart
  bool is_intersection = false;  ///< a connector, or in a road segment that is one
};

/// The lanes that come within `options.reach` of one of the places, in pieces of `options.points`
/// points; the last point of a piece is the first one of the next. Frame of `origin`, the places
/// and it in the map's. None where `options.max_lanes` is 0.
std::vector<TrafficLane> lanesAround(const std::vector<Vector2>& places, const Pose2& origin,
                                     const LaneIndex& lanes, const TrafficLaneOptions& options);

/// The pieces nearest to one of the places, `most` at most, nearest first. All in one frame.
std::vector<const TrafficLane*> nearestLanes(const std::vector<TrafficLane>& lanes,
                                             const std::vector<Vector2>& places, int most);

}  // namespace forge
