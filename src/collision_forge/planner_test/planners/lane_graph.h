#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "collision_forge/base/map/lane_queries.h"

namespace forge {

/// Lanes as short straight edges between nodes. Nodes and edges are named by their places in the
/// lists; what follows a node is in the order of the edges.
class LaneGraph {
 public:
  /// An edge leads from its first node to its second.
  using Edge = std::pair<std::size_t, std::size_t>;

  /// Throws std::invalid_argument for an edge without length or with a node that is not there.
  LaneGraph(std::vector<Vector2> nodes, std::vector<Edge> edges);

  const std::vector<Vector2>& nodes() const { return nodes_; }
  const std::vector<Edge>& edges() const { return edges_; }
  /// Nodes that an edge leads to from this one.
  const std::vector<std::size_t>& successors(std::size_t node) const { return successors_[node]; }
  /// Nodes that an edge leads from to this one.
  const std::vector<std::size_t>& predecessors(std::size_t node) const {
    return predecessors_[node];
  }

  /// At least all edges that come as near to a point, and others around; each once, rising.
  std::vector<std::size_t> edgesAround(const Vector2& point, double radius) const;

 private:
  void sortIntoCells();

  std::vector<Vector2> nodes_;
  std::vector<Edge> edges_;
  std::vector<std::vector<std::size_t>> successors_;
  std::vector<std::vector<std::size_t>> predecessors_;
  /// Squares of the plane that an edge's bounds touch, sorted, each with the edge.
  std::vector<std::pair<std::int64_t, std::size_t>> cells_;
};

/// The lanes of a map with the points of their centrelines as nodes, stretches longer than
/// `spacing` (m) divided. Where the end of a lane and the start of one that follows coincide they
/// are one node; else an edge joins them.
LaneGraph laneGraphOf(const LaneIndex& lanes, double spacing);

}  // namespace forge
