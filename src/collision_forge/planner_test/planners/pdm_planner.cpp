#include "collision_forge/planner_test/planners/pdm_planner.h"

#include <stdexcept>
#include <utility>

#include "collision_forge/planner_test/planners/lane_route.h"
#include "collision_forge/planner_test/planners/red_lights.h"
#include "collision_forge/planner_test/planners/route_road.h"

namespace forge {
PdmPlanner::PdmPlanner(const PdmOptions& options, const RouteCenterlineOptions& route,
                       const KinematicBicycleOptions& bicycle, const LqrOptions& lqr)
    : options_(options), route_options_(route), bicycle_options_(bicycle), lqr_options_(lqr) {}

void PdmPlanner::initialize(const DrivingTask& task) {
  if (!task.lanes) throw std::invalid_argument("the driving task has no lanes");
  task_ = task;
  bicycle_options_.wheelbase = task.wheelbase;
  RouteRoad road = roadAlong(*task.lanes, task.route, route_options_, options_.map);
  map_.emplace(std::move(road.map));
  lanes_.reset();
  closed_.emplace(PdmPath(std::move(road.nodes)), task.ego, bicycle_options_, lqr_options_,
                  options_);
}

std::vector<TrajectoryPoint> PdmPlanner::plan(const Observation& observation) {
  const double offset = task_.ego.center_offset;
  const BicycleState start = KinematicBicycle(bicycle_options_).stateOf(observation.ego, offset);
  const PdmPlace place = map_->placeOf({observation.ego.pose, task_.ego.size});
  if (!lanes_) lanes_ = laneRoute(*task_.lanes, task_.route, observation.ego.pose, route_options_);
  const std::vector<Track> agents =
      withRedLights(observation, task_.ego.size, *task_.lanes, *lanes_);
  const std::vector<Pose2> axles =
      closed_->plan(start, agents, *map_, place.speed_limit.value_or(options_.speed_limit));
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
