#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "collision_forge/base/map/lane_queries.h"

namespace forge {

/// A directed graph of lane centrelines: short straight edges between nodes. Nodes and edges are
/// identified by their indices; the neighbours of a node are listed in the order of the edges.
class LaneGraph {
 public:
  /// Indices in nodes() of the start node and the end node.
  using Edge = std::pair<std::size_t, std::size_t>;

  /// `nodes`: m, global map frame; `edges`: in driving direction. Throws std::invalid_argument for
  /// an edge of zero length or with an unknown node.
  LaneGraph(std::vector<Vector2> nodes, std::vector<Edge> edges);

  const std::vector<Vector2>& nodes() const { return nodes_; }  ///< m, global map frame
  const std::vector<Edge>& edges() const { return edges_; }     ///< in the order of the constructor
  /// Returns the nodes (indices) that an edge connects `node` to, in the order of the edges.
  const std::vector<std::size_t>& successors(std::size_t node) const { return successors_[node]; }
  /// Returns the nodes (indices) with an edge to `node`, in the order of the edges.
  const std::vector<std::size_t>& predecessors(std::size_t node) const {
    return predecessors_[node];
  }

  /// Returns a superset of the edges within `radius` metres of `point` (m, global map frame):
  /// ascending indices in edges(), no duplicates.
  std::vector<std::size_t> edgesAround(const Vector2& point, double radius) const;

 private:
  /// Fills cells_.
  void sortIntoCells();

  std::vector<Vector2> nodes_;
  std::vector<Edge> edges_;
  std::vector<std::vector<std::size_t>> successors_;
  std::vector<std::vector<std::size_t>> predecessors_;
  /// Grid cells that the bounding box of an edge touches, each with the edge; sorted.
  std::vector<std::pair<std::int64_t, std::size_t>> cells_;
};

/// Builds the graph of all lanes of a map from the points of their centrelines; splits stretches
/// longer than `spacing` metres into equal pieces of at most that length. If a lane's end and the
/// start of its successor are less than 0.1 m apart, they share a node; otherwise an edge joins
/// them. Edges lead in driving direction; lanes without a centreline have none, so a map without
/// lanes gives an empty graph.
LaneGraph laneGraphOf(const LaneIndex& lanes, double spacing);

}  // namespace forge
