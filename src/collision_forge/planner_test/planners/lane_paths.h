#pragma once

#include <vector>

#include "collision_forge/planner_test/planners/lane_graph.h"

namespace forge {

/// Nodes of a lane graph, each reached from the one before by an edge, or against it.
using NodePath = std::vector<std::size_t>;

enum class PathDirection { kAhead, kBehind };

/// All paths from a node on that are `length` metres long or end before where the lanes do, in the
/// order of the edges at each branch; the first `max_paths` of them. No path passes on when it is
/// long enough.
std::vector<NodePath> nodePaths(const LaneGraph& graph, std::size_t node, PathDirection direction,
                                double length, std::size_t max_paths);

}  // namespace forge
