#include "collision_forge/planners/pdm_planner.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <utility>

#include "collision_forge/map/reference_path.h"

namespace forge {
namespace {

/// A smooth line's nodes, as far apart as those of nuPlan's centrelines mostly are.
std::vector<Pose2> nodesOf(const Polyline& line) {
  constexpr double kSpacing = 1.0;  // m
  const ReferencePath path(line);
  const int count = std::max(1, static_cast<int>(std::ceil(path.length() / kSpacing)));
  std::vector<Pose2> nodes;
  for (int i = 0; i <= count; ++i) nodes.push_back(path.at(path.length() * i / count).pose);
  return nodes;
}

/// The strip of a width along a line.
std::vector<Vector2> stripAlong(const std::vector<Pose2>& line, double width) {
  std::vector<Vector2> outline;
  for (const Pose2& pose : line) {
    outline.push_back(compose(pose, {0.0, 0.5 * width, 0.0}).position());
  }
  for (auto pose = line.rbegin(); pose != line.rend(); ++pose) {
    outline.push_back(compose(*pose, {0.0, -0.5 * width, 0.0}).position());
  }
  return outline;
}

/// Indices of the lanes of the roads that the route takes.
std::set<std::size_t> lanesOnRoute(const LaneIndex& lanes, const std::vector<Pose2>& route,
                                   const PdmMapOptions& options) {
  std::set<std::size_t> found;
  for (const Pose2& place : route) {
    for (const LaneMatch& match :
         lanes.lanesNear(place, options.road_half_width, options.road_heading)) {
      found.insert(match.lane);
    }
  }
  return found;
}

/// The lanes around the route; a lane without an outline is a strip along its centreline. Where the
/// route leaves the lanes, a strip along it is on the route, too.
PdmMap mapAlong(const LaneIndex& lanes, const std::vector<Pose2>& route,
                const PdmMapOptions& options) {
  const std::set<std::size_t> on_route = lanesOnRoute(lanes, route, options);
  std::set<std::size_t> around;
  const auto stride = static_cast<std::size_t>(std::max(1.0, options.radius));
  for (std::size_t i = 0; i < route.size(); i += stride) {
    for (const std::size_t lane : lanes.lanesWithin(route[i].position(), options.radius)) {
      around.insert(lane);
    }
  }
  std::vector<PdmArea> areas;
  std::vector<std::vector<Vector2>> intersections;
  for (const std::size_t index : around) {
    const Lane& lane = lanes.map().lanes[index];
    std::vector<Vector2> outline =
        lane.polygon.size() >= 3 ? lane.polygon : stripAlong(lane.centerline, options.lane_width);
    if (lane.is_connector || lane.is_intersection) intersections.push_back(outline);
    areas.push_back({std::move(outline), on_route.count(index) > 0});
  }
  PdmMap map(areas, intersections);
  map.addRoute(stripAlong(route, options.lane_width));
  if (!lanes.drivable().empty()) map.setDrivable(&lanes.drivable(), options.drivable_margin);
  return map;
}

}  // namespace

PdmPlanner::PdmPlanner(const PdmOptions& options, const RouteCenterlineOptions& route,
                       const KinematicBicycleOptions& bicycle, const LqrOptions& lqr)
    : options_(options), route_options_(route), bicycle_options_(bicycle), lqr_options_(lqr) {}

void PdmPlanner::initialize(const DrivingTask& task) {
  if (!task.lanes) throw std::invalid_argument("a driving task needs lanes");
  task_ = task;
  bicycle_options_.wheelbase = task.wheelbase;
  const std::vector<Pose2> nodes =
      nodesOf(routeCenterline(*task.lanes, task.route, route_options_));
  map_.emplace(mapAlong(*task.lanes, nodes, options_.map));
  closed_.emplace(PdmPath(nodes), task.ego, bicycle_options_, lqr_options_, options_);
}

std::vector<TrajectoryPoint> PdmPlanner::plan(const Observation& observation) {
  const double offset = task_.ego.center_offset;
  const BicycleState start = KinematicBicycle(bicycle_options_).stateOf(observation.ego, offset);
  const std::vector<Pose2> axles =
      closed_->plan(start, observation.agents, *map_, options_.speed_limit);
  std::vector<TrajectoryPoint> points;
  for (std::size_t i = 0; i < axles.size(); ++i) {
    const double time = observation.ego.time + static_cast<double>(i) * options_.step;
    const Vector2 moved = axles[i].position() - axles[i > 0 ? i - 1 : 0].position();
    points.push_back({time, boxMiddleOf(axles[i], offset),
                      axles[i].heading().dot(moved) / options_.step, 0.0, 0.0});
  }
  points.front().speed = start.speed;
  return points;
}

std::vector<std::vector<Pose2>> PdmPlanner::proposals() const {
  std::vector<std::vector<Pose2>> proposals;
  if (!closed_) return proposals;
  for (const PdmCandidate& candidate : closed_->candidates()) {
    std::vector<Pose2>& poses = proposals.emplace_back();
    for (const OrientedBox& box : candidate.motion.boxes) poses.push_back(box.center);
  }
  return proposals;
}

}  // namespace forge
