#include "collision_forge/planner_test/planners/route.h"

#include <algorithm>
#include <stdexcept>

namespace forge {
namespace {

constexpr double kRounding = 1e-6;  // m

/// Returns the path along the lane of the last pose, starting beside it; straight ahead if no lane
/// is near and where the lanes end.
std::vector<Vector2> roadAhead(const Pose2& last, const LaneIndex& lanes,
                               const RouteOptions& options) {
  const auto matches = lanes.lanesNear(last, options.end_lane_distance, options.end_lane_heading);
  if (matches.empty()) return {last.position() + options.length_ahead * last.heading()};
  const LaneMatch& nearest = matches.front();
  const Polyline path =
      lanes.pathAhead(nearest.lane, nearest.projection.arc_length, options.length_ahead);
  std::vector<Vector2> points = path.points();
  if (path.length() < options.length_ahead - kRounding) {
    points.push_back(path.poseAt(options.length_ahead).position());
  }
  return points;
}

}  // namespace

std::vector<Vector2> routeOf(const Track& recorded, const LaneIndex& lanes,
                             const RouteOptions& options) {
  if (recorded.states.empty()) {
    throw std::invalid_argument("cannot derive a route: track " + recorded.id + " has no states");
  }
  std::vector<Vector2> points = {recorded.states.front().pose.position()};
  for (const AgentState& state : recorded.states) {
    if ((state.pose.position() - points.back()).norm() >= options.spacing) {
      points.push_back(state.pose.position());
    }
  }
  const Pose2& last = recorded.states.back().pose;
  const std::vector<Vector2> way = roadAhead(last, lanes, options);
  const auto joined = std::find_if(way.begin(), way.end(), [&](const Vector2& point) {
    return (point - last.position()).dot(last.heading()) >= options.join_distance;
  });
  points.insert(points.end(), joined, way.end());
  if (points.size() < 2) points.push_back(last.position() + options.length_ahead * last.heading());
  return points;
}

}  // namespace forge
