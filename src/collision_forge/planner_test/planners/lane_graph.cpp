#include "collision_forge/planner_test/planners/lane_graph.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <stdexcept>

namespace forge {
namespace {

constexpr double kCellSize = 10.0;   // m
constexpr double kCoincident = 0.1;  // m; closer ends of lanes share a node
constexpr double kRounding = 1e-6;   // share of a piece by which a stretch may be longer

std::int64_t column(double coordinate) {
  return static_cast<std::int64_t>(std::floor(coordinate / kCellSize));
}

std::int64_t cellAt(std::int64_t x, std::int64_t y) { return x * (std::int64_t{1} << 32) + y; }

/// Disjoint sets of the starts (even) and ends (odd) of lanes that share a node.
class LaneEnds {
 public:
  explicit LaneEnds(std::size_t lanes) : parents_(2 * lanes) {
    std::iota(parents_.begin(), parents_.end(), std::size_t{0});
  }

  static std::size_t start(std::size_t lane) { return 2 * lane; }
  static std::size_t end(std::size_t lane) { return 2 * lane + 1; }

  /// Returns the representative of the ends that share a node with `end`.
  std::size_t root(std::size_t place) {
    while (parents_[place] != place) place = parents_[place] = parents_[parents_[place]];
    return place;
  }
  void join(std::size_t a, std::size_t b) { parents_[root(b)] = root(a); }

 private:
  std::vector<std::size_t> parents_;
};

/// Collects nodes and edges from the lanes.
class GraphBuilder {
 public:
  GraphBuilder(const LaneIndex& lanes, double spacing)
      : lanes_(lanes), spacing_(spacing), ends_(lanes.map().lanes.size()) {
    forEachStep([&](std::size_t lane, std::size_t next) {
      if ((endOf(lane) - startOf(next)).norm() < kCoincident) {
        ends_.join(LaneEnds::end(lane), LaneEnds::start(next));
      }
    });
  }

  LaneGraph build() {
    for (std::size_t lane = 0; lane < lanes_.map().lanes.size(); ++lane) {
      if (lanes_.centerline(lane)) addLane(lane);
    }
    forEachStep([&](std::size_t lane, std::size_t next) {
      addEdge(nodeAt(LaneEnds::end(lane), endOf(lane)),
              nodeAt(LaneEnds::start(next), startOf(next)));
    });
    return {std::move(nodes_), std::move(edges_)};
  }

 private:
  Vector2 startOf(std::size_t lane) const { return lanes_.centerline(lane)->points().front(); }
  Vector2 endOf(std::size_t lane) const { return lanes_.centerline(lane)->points().back(); }

  /// Adds edges from lanes to their successors if both have a centreline.
  template <class Visit>
  void forEachStep(const Visit& visit) const {
    for (std::size_t lane = 0; lane < lanes_.map().lanes.size(); ++lane) {
      for (const std::size_t next : lanes_.successors(lane)) {
        if (lanes_.centerline(lane) && lanes_.centerline(next)) visit(lane, next);
      }
    }
  }

  void addLane(std::size_t lane) {
    const std::vector<Vector2>& points = lanes_.centerline(lane)->points();
    std::size_t node = nodeAt(LaneEnds::start(lane), points.front());
    for (std::size_t i = 1; i + 1 < points.size(); ++i) node = extend(node, addNode(points[i]));
    extend(node, nodeAt(LaneEnds::end(lane), points.back()));
  }

  std::size_t nodeAt(std::size_t place, const Vector2& point) {
    const auto known = known_.find(ends_.root(place));
    if (known != known_.end()) return known->second;
    return known_[ends_.root(place)] = addNode(point);
  }

  std::size_t addNode(const Vector2& point) {
    nodes_.push_back(point);
    return nodes_.size() - 1;
  }

  void addEdge(std::size_t from, std::size_t to) {
    if ((nodes_[to] - nodes_[from]).norm() > 0.0) edges_.emplace_back(from, to);
  }

  std::size_t extend(std::size_t from, std::size_t to) {
    const Vector2 start = nodes_[from];
    const Vector2 span = nodes_[to] - start;
    const int pieces = std::max(1, static_cast<int>(std::ceil(span.norm() / spacing_ - kRounding)));
    for (int i = 1; i < pieces; ++i) {
      const std::size_t node = addNode(start + span * i / pieces);
      addEdge(from, node);
      from = node;
    }
    addEdge(from, to);
    return to;
  }

  const LaneIndex& lanes_;
  double spacing_;
  LaneEnds ends_;
  std::vector<Vector2> nodes_;
  std::vector<LaneGraph::Edge> edges_;
  std::map<std::size_t, std::size_t> known_;  // nodes of the roots of ends
};

}  // namespace

LaneGraph::LaneGraph(std::vector<Vector2> nodes, std::vector<Edge> edges)
    : nodes_(std::move(nodes)),
      edges_(std::move(edges)),
      successors_(nodes_.size()),
      predecessors_(nodes_.size()) {
  for (const Edge& edge : edges_) {
    if (edge.first >= nodes_.size() || edge.second >= nodes_.size() ||
        !((nodes_[edge.second] - nodes_[edge.first]).norm() > 0.0)) {
      throw std::invalid_argument("an edge of a lane graph needs two nodes apart");
    }
    successors_[edge.first].push_back(edge.second);
    predecessors_[edge.second].push_back(edge.first);
  }
  sortIntoCells();
}

void LaneGraph::sortIntoCells() {
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    const Vector2& a = nodes_[edges_[i].first];
    const Vector2& b = nodes_[edges_[i].second];
    const Vector2 low = a.cwiseMin(b);
    const Vector2 high = a.cwiseMax(b);
    for (std::int64_t x = column(low.x()); x <= column(high.x()); ++x) {
      for (std::int64_t y = column(low.y()); y <= column(high.y()); ++y) {
        cells_.emplace_back(cellAt(x, y), i);
      }
    }
  }
  std::sort(cells_.begin(), cells_.end());
}

std::vector<std::size_t> LaneGraph::edgesAround(const Vector2& point, double radius) const {
  std::vector<std::size_t> found;
  for (std::int64_t x = column(point.x() - radius); x <= column(point.x() + radius); ++x) {
    for (std::int64_t y = column(point.y() - radius); y <= column(point.y() + radius); ++y) {
      auto entry = std::lower_bound(cells_.begin(), cells_.end(),
                                    std::make_pair(cellAt(x, y), std::size_t{0}));
      for (; entry != cells_.end() && entry->first == cellAt(x, y); ++entry) {
        found.push_back(entry->second);
      }
    }
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

LaneGraph laneGraphOf(const LaneIndex& lanes, double spacing) {
  return GraphBuilder(lanes, spacing).build();
}

}  // namespace forge
