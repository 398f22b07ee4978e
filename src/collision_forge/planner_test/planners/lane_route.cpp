#include "collision_forge/planner_test/planners/lane_route.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <tuple>

namespace forge {
namespace {

/// The farthest place along the route that a lane comes near.
struct Reach {
  int place = 0;          ///< index of that place
  double distance = 0.0;  ///< m between both there
};

bool isFarther(const Reach& a, const Reach& b) {
  return std::make_tuple(a.place, -a.distance) > std::make_tuple(b.place, -b.distance);
}

/// Lanes near the route, by lane index.
using RouteLanes = std::map<std::size_t, Reach>;

RouteLanes lanesAlong(const LaneIndex& lanes, const std::vector<Vector2>& route,
                      const RouteCenterlineOptions& options) {
  const Polyline line(route);
  const int count = std::max(1, static_cast<int>(std::lround(line.length() / options.spacing)));
  RouteLanes found;
  for (int place = 0; place <= count; ++place) {
    const Pose2 pose = line.poseAt(line.length() * place / count);
    for (const LaneMatch& match :
         lanes.lanesNear(pose, options.route_lane_distance, options.route_lane_heading)) {
      found[match.lane] = {place, match.projection.distance};
    }
  }
  return found;
}

/// Returns the lanes along the route that contain the start, else the nearest ones.
std::vector<std::size_t> startLanes(const LaneIndex& lanes, const RouteLanes& along,
                                    const Pose2& start, const RouteCenterlineOptions& options) {
  constexpr double kEquallyNear = 0.1;  // m
  std::vector<std::size_t> holding;
  std::vector<std::size_t> nearest;
  double least = 0.0;
  for (const LaneMatch& match :
       lanes.lanesNear(start, options.route_lane_distance, options.route_lane_heading)) {
    if (along.count(match.lane) == 0) continue;
    const Polygon outline{lanes.map().lanes[match.lane].polygon, {}};
    if (contains(outline, start.position())) holding.push_back(match.lane);
    if (nearest.empty()) least = match.projection.distance;
    if (match.projection.distance <= least + kEquallyNear) nearest.push_back(match.lane);
  }
  return holding.empty() ? nearest : holding;
}

/// Breadth-first search over lanes and their successors.
class Search {
 public:
  Search(const LaneIndex& lanes, const RouteLanes& along) : lanes_(lanes), along_(along) {}

  /// Returns the lanes from `start` to the one that gets farthest along the route.
  std::vector<std::size_t> from(std::size_t start) {
    before_ = {{start, start}};
    std::deque<std::size_t> open = {start};
    std::size_t best = start;
    while (!open.empty()) {
      const std::size_t lane = open.front();
      open.pop_front();
      if (isFarther(along_.at(lane), along_.at(best))) best = lane;
      for (const std::size_t next : lanes_.successors(lane)) {
        const bool is_new = along_.count(next) > 0 && lanes_.centerline(next);
        if (is_new && before_.emplace(next, lane).second) open.push_back(next);
      }
    }
    return pathTo(best);
  }

 private:
  std::vector<std::size_t> pathTo(std::size_t lane) const {
    std::vector<std::size_t> path = {lane};
    while (before_.at(lane) != lane) {
      lane = before_.at(lane);
      path.push_back(lane);
    }
    std::reverse(path.begin(), path.end());
    return path;
  }

  const LaneIndex& lanes_;
  const RouteLanes& along_;
  std::map<std::size_t, std::size_t> before_;  // the lane that each was reached from
};

}  // namespace

std::vector<std::size_t> laneRoute(const LaneIndex& lanes, const std::vector<Vector2>& route,
                                   const Pose2& start, const RouteCenterlineOptions& options) {
  const RouteLanes along = lanesAlong(lanes, route, options);
  std::vector<std::size_t> best;
  for (const std::size_t lane : startLanes(lanes, along, start, options)) {
    const std::vector<std::size_t> path = Search(lanes, along).from(lane);
    if (best.empty() || isFarther(along.at(path.back()), along.at(best.back()))) best = path;
  }
  return best;
}

}  // namespace forge
