#include "collision_forge/study/generators/traffic_lanes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

namespace forge {
namespace {

double distanceTo(const TrafficLane& lane, const std::vector<Vector2>& places) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Pose2& point : lane.points) {
    for (const Vector2& place : places) {
      nearest = std::min(nearest, (point.position() - place).norm());
    }
  }
  return nearest;
}

/// Splits a lane into pieces; omits a remainder of less than half the spacing.
std::vector<TrafficLane> piecesOf(const Polyline& line, bool is_intersection,
                                  const TrafficLaneOptions& options) {
  const int steps = std::max(1, static_cast<int>(std::lround(line.length() / options.spacing)));
  std::vector<TrafficLane> pieces;
  for (int first = 0; first < steps; first += options.points - 1) {
    TrafficLane piece;
    piece.is_intersection = is_intersection;
    const int last = std::min(first + options.points - 1, steps);
    for (int step = first; step <= last; ++step) {
      piece.points.push_back(line.poseAt(std::min(step * options.spacing, line.length())));
    }
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

}  // namespace

std::vector<TrafficLane> lanesAround(const std::vector<Vector2>& places, const Pose2& origin,
                                     const LaneIndex& lanes, const TrafficLaneOptions& options) {
  std::vector<TrafficLane> found;
  if (options.max_lanes == 0) return found;
  std::set<std::size_t> within;
  for (const Vector2& place : places) {
    for (const std::size_t lane : lanes.lanesWithin(place, options.reach)) within.insert(lane);
  }
  for (const std::size_t index : within) {
    const Lane& lane = lanes.map().lanes[index];
    const bool is_intersection = lane.is_connector || lane.is_intersection;
    for (TrafficLane& piece : piecesOf(*lanes.centerline(index), is_intersection, options)) {
      if (distanceTo(piece, places) > options.reach) continue;
      for (Pose2& point : piece.points) point = relativeTo(origin, point);
      found.push_back(std::move(piece));
    }
  }
  return found;
}

std::vector<const TrafficLane*> nearestLanes(const std::vector<TrafficLane>& lanes,
                                             const std::vector<Vector2>& places, int most) {
  std::vector<std::pair<double, const TrafficLane*>> ranked;
  for (const TrafficLane& lane : lanes) ranked.emplace_back(distanceTo(lane, places), &lane);
  std::stable_sort(ranked.begin(), ranked.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  if (ranked.size() > static_cast<std::size_t>(most)) ranked.resize(static_cast<std::size_t>(most));
  std::vector<const TrafficLane*> nearest;
  for (const auto& entry : ranked) nearest.push_back(entry.second);
  return nearest;
}

}  // namespace forge
