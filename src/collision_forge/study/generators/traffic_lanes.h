#pragma once

#include <vector>

#include "collision_forge/base/map/lane_queries.h"
#include "collision_forge/study/generators/options.h"

namespace forge {

/// A piece of a lane's centreline, in driving direction.
struct TrafficLane {
  std::vector<Pose2> points;  ///< at least two, TrafficLaneOptions::spacing apart (m), the last of
                              ///< a lane perhaps nearer
  bool is_intersection = false;  ///< a connector, or in a road segment that is an intersection
};

/// Returns the lanes within `options.reach` of one of `places`, in pieces of `options.points`
/// points (the last piece of a lane may have fewer), in the order of LaneMap::lanes; the last point
/// of a piece is the first of the next. Pieces beyond the reach of all places are left out.
/// `places` and `origin` are in the map frame, the result is in the frame of `origin`. Empty if
/// `options.max_lanes` is 0.
std::vector<TrafficLane> lanesAround(const std::vector<Vector2>& places, const Pose2& origin,
                                     const LaneIndex& lanes, const TrafficLaneOptions& options);

/// Returns at most `most` of the pieces `lanes`, nearest first by the distance of any of their
/// points to any of `places`. `lanes`, into which the result points, and `places` must be in the
/// same frame.
std::vector<const TrafficLane*> nearestLanes(const std::vector<TrafficLane>& lanes,
                                             const std::vector<Vector2>& places, int most);

}  // namespace forge
