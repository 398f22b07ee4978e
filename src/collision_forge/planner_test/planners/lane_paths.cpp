#include "collision_forge/planner_test/planners/lane_paths.h"

#include <utility>

namespace forge {
namespace {

class PathSearch {
 public:
  PathSearch(const LaneGraph& graph, PathDirection direction, double length, std::size_t max_paths)
      : graph_(graph), direction_(direction), length_(length), max_paths_(max_paths) {}

  std::vector<NodePath> from(std::size_t node) {
    NodePath path = {node};
    follow(path, 0.0);
    return std::move(found_);
  }

 private:
  void follow(NodePath& path, double length) {
    const std::vector<std::size_t>& next = direction_ == PathDirection::kAhead
                                               ? graph_.successors(path.back())
                                               : graph_.predecessors(path.back());
    if (length >= length_ || next.empty()) {
      found_.push_back(path);
      return;
    }
    const Vector2 here = graph_.nodes()[path.back()];
    for (const std::size_t node : next) {
      if (found_.size() >= max_paths_) return;
      path.push_back(node);
      follow(path, length + (graph_.nodes()[node] - here).norm());
      path.pop_back();
    }
  }

  const LaneGraph& graph_;
  PathDirection direction_;
  double length_;
  std::size_t max_paths_;
  std::vector<NodePath> found_;
};

}  // namespace

std::vector<NodePath> nodePaths(const LaneGraph& graph, std::size_t node, PathDirection direction,
                                double length, std::size_t max_paths) {
  return PathSearch(graph, direction, length, max_paths).from(node);
}

}  // namespace forge
