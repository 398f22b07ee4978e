#pragma once

#include <vector>

#include "collision_forge/planner_test/planners/lane_graph.h"

namespace forge {

/// Nodes of a lane graph (indices in LaneGraph::nodes()) along a path; an edge connects each node
/// with the one before it, in driving direction or against it.
using NodePath = std::vector<std::size_t>;

/// Direction of a path: along the edges (kAhead) or against them (kBehind).
enum class PathDirection { kAhead, kBehind };

/// Returns the first `max_paths` (> 0) paths that begin with `node`, depth first in the order of
/// the edges at each branch; at least one. A path ends at the first node at which it is at least
/// `length` metres long, or, possibly shorter, where the lanes end; it consists of `node` alone if
/// no edge leads on.
std::vector<NodePath> nodePaths(const LaneGraph& graph, std::size_t node, PathDirection direction,
                                double length, std::size_t max_paths);

}  // namespace forge
