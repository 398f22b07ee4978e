#pragma once

#include <vector>

#include "collision_forge/planner_test/planners/lane_graph.h"
#include "collision_forge/planner_test/planners/rule_based_options.h"

namespace forge {

/// An edge of a lane graph that a vehicle may be driving on.
struct EdgeMatch {
  std::size_t edge = 0;   ///< index in LaneGraph::edges()
  double distance = 0.0;  ///< m from the vehicle's middle to the edge
  /// Point of the edge that is nearest to the vehicle's middle; m, global map frame.
  Vector2 closest{0.0, 0.0};
};

/// Returns the edges within `options.on_lane_distance` of the vehicle's middle (pose in the global
/// map frame) whose direction is within `options.on_lane_heading` of its heading, nearest first
/// (equally near ones by index). From each chain of connected edges among these, keeps only the
/// nearest. Empty if the vehicle is on no lane.
std::vector<EdgeMatch> matchedEdges(const LaneGraph& graph, const Pose2& vehicle,
                                    const RuleBasedOptions& options);

/// Returns the point of the straight segment from `from` to `to` that is nearest to `point`.
Vector2 closestBetween(const Vector2& from, const Vector2& to, const Vector2& point);

}  // namespace forge
