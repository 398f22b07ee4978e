#pragma once

#include <vector>

#include "collision_forge/planner_test/planners/lane_graph.h"
#include "collision_forge/planner_test/planners/rule_based_options.h"

namespace forge {

/// An edge of a lane graph that a vehicle may be driving on.
struct EdgeMatch {
  std::size_t edge = 0;
  double distance = 0.0;      ///< m to it
  Vector2 closest{0.0, 0.0};  ///< the point of it that is nearest
};

/// The edges near a vehicle that lead about where it heads, nearest first: of those that lead to
/// each other over edges that are near, too, the nearest alone.
std::vector<EdgeMatch> matchedEdges(const LaneGraph& graph, const Pose2& vehicle,
                                    const RuleBasedOptions& options);

/// The point of a straight line between two points that is nearest to another.
Vector2 closestBetween(const Vector2& from, const Vector2& to, const Vector2& point);

}  // namespace forge
