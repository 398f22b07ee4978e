#include "collision_forge/planner_test/planners/rule_based_planner.h"

#include <cmath>
#include <stdexcept>

namespace forge {
namespace {

Pose2 poseOn(const LaneSpline& way, double distance) {
  const LaneSpline::Point point = way.at(distance);
  return {point.position.x(), point.position.y(), std::atan2(point.heading.y(), point.heading.x())};
}

/// Returns the ego's trajectory: at t0, after one step as poseAfterStep() returns it, then along
/// its path.
std::vector<TrajectoryPoint> pointsAlong(const LaneSpline& way, const SpeedPlan& plan,
                                         const TrajectoryPoint& now,
                                         const RuleBasedOptions& options) {
  std::vector<TrajectoryPoint> points;
  for (std::size_t i = 0; i < plan.speeds.size(); ++i) {
    TrajectoryPoint point = now;
    point.time = now.time + static_cast<double>(i) * options.step;
    if (i == 1) point.pose = poseAfterStep(now.pose, way, plan);
    if (i > 1) point.pose = poseOn(way, plan.distances[i]);
    point.speed = plan.speeds[i];
    const std::size_t next = i + 1 < plan.speeds.size() ? i + 1 : i;
    point.acceleration = (plan.speeds[next] - plan.speeds[i]) / options.step;
    if (i > 0) {
      const double on = plan.distances[i] + options.sample_spacing;
      point.curvature = angleBetween(point.pose.yaw, poseOn(way, on).yaw) / options.sample_spacing;
    }
    points.push_back(point);
  }
  return points;
}

std::vector<DrivenBox> boxesOf(const std::vector<Track>& agents) {
  std::vector<DrivenBox> boxes;
  for (const Track& agent : agents) {
    if (agent.states.empty()) continue;
    const AgentState& now = agent.states.back();
    boxes.push_back({now.pose, now.velocity.dot(now.pose.heading()), agent.size});
  }
  return boxes;
}

}  // namespace

void RuleBasedPlanner::initialize(const DrivingTask& task) {
  if (!task.lanes) throw std::invalid_argument("the driving task has no lanes");
  task_ = task;
  graph_.emplace(laneGraphOf(*task.lanes, options_.node_spacing));
  const Polyline route(task.route);
  route_.reset();
  if (options_.ego_way == EgoWay::kAlongRoute) route_ = route;
  last_.reset();
}

std::vector<TrajectoryPoint> RuleBasedPlanner::plan(const Observation& observation) {
  const TrajectoryPoint& now = observation.ego;
  last_ = planOnLanes({now.pose, now.speed, task_.ego.size}, boxesOf(observation.agents), *graph_,
                      route_ ? &*route_ : nullptr, options_);
  const RuleBasedChoice& choice = last_->choice;
  return pointsAlong(last_->way, choice.profiles[choice.chosen].profile.plan, now, options_);
}

std::vector<std::vector<Pose2>> RuleBasedPlanner::proposals() const {
  std::vector<std::vector<Pose2>> proposals;
  if (!last_) return proposals;
  for (const WeighedProfile& weighed : last_->choice.profiles) {
    std::vector<Pose2>& poses = proposals.emplace_back();
    for (const double distance : weighed.profile.plan.distances) {
      poses.push_back(poseOn(last_->way, distance));
    }
  }
  return proposals;
}

}  // namespace forge
