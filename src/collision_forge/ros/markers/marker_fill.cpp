#include "collision_forge/ros/markers/marker_fill.h"

#include <algorithm>

namespace forge {

namespace {

struct Edge {
  Vector2 bottom;
  Vector2 top;  ///< above bottom

  double xAt(double y) const {
    return bottom.x() + (top.x() - bottom.x()) * (y - bottom.y()) / (top.y() - bottom.y());
  }
};

void addEdges(const std::vector<Vector2>& ring, std::vector<Edge>& edges) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vector2& from = ring[i];
    const Vector2& to = ring[(i + 1) % ring.size()];
    if (from.y() < to.y()) edges.push_back({from, to});
    if (from.y() > to.y()) edges.push_back({to, from});
  }
}

bool isFinite(const std::vector<Edge>& edges) {
  return std::all_of(edges.begin(), edges.end(), [](const Edge& edge) {
    return edge.bottom.allFinite() && edge.top.allFinite();
  });
}

/// The edges' parts between two heights, each as bottom and top, from left to right.
std::vector<Edge> crossings(const std::vector<Edge>& edges, double bottom, double top) {
  std::vector<Edge> parts;
  parts.reserve(edges.size());
  for (const Edge& edge : edges) {
    parts.push_back({{edge.xAt(bottom), bottom}, {edge.xAt(top), top}});
  }
  std::sort(parts.begin(), parts.end(), [](const Edge& a, const Edge& b) {
    return a.bottom.x() + a.top.x() < b.bottom.x() + b.top.x();
  });
  return parts;
}

void addTrapezoid(const Edge& left, const Edge& right, std::vector<Vector2>& triangles) {
  if (left.bottom.x() < right.bottom.x()) {
    triangles.insert(triangles.end(), {left.bottom, right.bottom, right.top});
  }
  if (left.top.x() < right.top.x()) {
    triangles.insert(triangles.end(), {left.bottom, right.top, left.top});
  }
}

}  // namespace

std::vector<Vector2> fillTriangles(const Polygon& polygon) {
  std::vector<Edge> edges;
  addEdges(polygon.exterior, edges);
  for (const std::vector<Vector2>& hole : polygon.holes) addEdges(hole, edges);
  if (!isFinite(edges)) return {};

  std::sort(edges.begin(), edges.end(),
            [](const Edge& a, const Edge& b) { return a.bottom.y() < b.bottom.y(); });
  std::vector<double> heights;
  for (const Edge& edge : edges) heights.insert(heights.end(), {edge.bottom.y(), edge.top.y()});
  std::sort(heights.begin(), heights.end());
  heights.erase(std::unique(heights.begin(), heights.end()), heights.end());

  std::vector<Vector2> triangles;
  std::vector<Edge> active;
  auto next = edges.begin();
  for (std::size_t i = 0; i + 1 < heights.size(); ++i) {
    const double bottom = heights[i];
    active.erase(std::remove_if(active.begin(), active.end(),
                                [bottom](const Edge& edge) { return edge.top.y() <= bottom; }),
                 active.end());
    for (; next != edges.end() && next->bottom.y() <= bottom; ++next) active.push_back(*next);
    const std::vector<Edge> parts = crossings(active, bottom, heights[i + 1]);
    for (std::size_t k = 0; k + 1 < parts.size(); k += 2) {
      addTrapezoid(parts[k], parts[k + 1], triangles);
    }
  }
  return triangles;
}

}  // namespace forge
