#include "collision_forge/planner_test/planners/lane_matches.h"

#include <algorithm>
#include <cmath>

#include "collision_forge/base/geometry/segment.h"

namespace forge {
namespace {

/// Returns all edges near a vehicle with a similar direction, nearest first.
std::vector<EdgeMatch> edgesAlong(const LaneGraph& graph, const Pose2& vehicle,
                                  const RuleBasedOptions& options) {
  std::vector<EdgeMatch> matches;
  const Vector2 heading = vehicle.heading();
  for (const std::size_t i : graph.edgesAround(vehicle.position(), options.on_lane_distance)) {
    const Vector2& from = graph.nodes()[graph.edges()[i].first];
    const Vector2& to = graph.nodes()[graph.edges()[i].second];
    const double cosine = std::clamp((to - from).normalized().dot(heading), -1.0, 1.0);
    const Vector2 closest = closestBetween(from, to, vehicle.position());
    const double distance = (closest - vehicle.position()).norm();
    if (distance > options.on_lane_distance || std::acos(cosine) > options.on_lane_heading) {
      continue;
    }
    matches.push_back({i, distance, closest});
  }
  std::stable_sort(matches.begin(), matches.end(),
                   [](const EdgeMatch& a, const EdgeMatch& b) { return a.distance < b.distance; });
  return matches;
}

/// Marks the matches that are reachable from a match over nearby edges, or with `backwards` those
/// from which it is reachable.
void markConnected(const LaneGraph& graph, const std::vector<EdgeMatch>& matches, std::size_t from,
                   bool backwards, std::vector<char>& is_marked) {
  std::vector<char> is_seen(matches.size(), 0);
  std::vector<std::size_t> open = {from};
  is_seen[from] = 1;
  while (!open.empty()) {
    const LaneGraph::Edge& edge = graph.edges()[matches[open.back()].edge];
    open.pop_back();
    for (std::size_t i = 0; i < matches.size(); ++i) {
      const LaneGraph::Edge& other = graph.edges()[matches[i].edge];
      const bool follows = backwards ? other.second == edge.first : other.first == edge.second;
      if (is_seen[i] || !follows) continue;
      is_seen[i] = is_marked[i] = 1;
      open.push_back(i);
    }
  }
}

}  // namespace

Vector2 closestBetween(const Vector2& from, const Vector2& to, const Vector2& point) {
  return from + nearestShare(from, to, point) * (to - from);
}

std::vector<EdgeMatch> matchedEdges(const LaneGraph& graph, const Pose2& vehicle,
                                    const RuleBasedOptions& options) {
  const std::vector<EdgeMatch> matches = edgesAlong(graph, vehicle, options);
  std::vector<char> is_covered(matches.size(), 0);
  std::vector<EdgeMatch> nearest;
  for (std::size_t i = 0; i < matches.size(); ++i) {
    if (is_covered[i]) continue;
    nearest.push_back(matches[i]);
    markConnected(graph, matches, i, false, is_covered);
    markConnected(graph, matches, i, true, is_covered);
  }
  return nearest;
}

}  // namespace forge
