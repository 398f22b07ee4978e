#include "collision_forge/planner_test/planners/idm.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "collision_forge/planner_test/planners/lane_route.h"
#include "collision_forge/planner_test/planners/red_lights.h"

namespace forge {
namespace {

constexpr double kStanding = 0.01;  // m; a shorter displacement has no curvature
constexpr double kRounding = 1e-6;  // m; slack of distances used for pruning

/// Returns the point `step` seconds after `before`, with the curvature of the path in between.
TrajectoryPoint pointAfter(const TrajectoryPoint& before, double step, const Pose2& pose,
                           double speed) {
  TrajectoryPoint point{before.time + step, pose, speed, (speed - before.speed) / step, 0.0};
  const double driven = (pose.position() - before.pose.position()).norm();
  if (driven > kStanding) point.curvature = angleBetween(before.pose.yaw, pose.yaw) / driven;
  return point;
}

/// Returns the nodes of the lanes' centrelines and, where these end beside the route, of the route
/// after a lane change; of the whole route if there are no lanes.
std::vector<Pose2> nodesOf(const DrivingTask& task, const std::vector<std::size_t>& lanes,
                           const RouteCenterlineOptions& options) {
  std::vector<Pose2> nodes;
  for (const std::size_t lane : lanes) {
    const std::vector<Pose2>& line = task.lanes->map().lanes[lane].centerline;
    nodes.insert(nodes.end(), line.begin(), line.end());
  }
  const Polyline route(task.route);
  double from = 0.0;
  if (!nodes.empty()) {
    const PolylineProjection end = route.project(nodes.back().position());
    from = end.arc_length + options.lane_change_length;
    if (end.distance > options.route_lane_distance || from >= route.length()) return nodes;
  }
  const double length = route.length() - from;
  const int count = std::max(2, static_cast<int>(std::ceil(length / options.spacing)));
  for (int i = 0; i <= count; ++i) nodes.push_back(route.poseAt(from + length * i / count));
  return nodes;
}

/// An agent near the ego.
struct Other {
  OrientedBox box;
  double radius = 0.0;  ///< m, of the circle around it
  double speed = 0.0;   ///< m/s along its heading; 0 for an object
};

std::vector<Other> othersNear(const std::vector<Track>& agents, const Vector2& ego, double radius) {
  std::vector<Other> others;
  for (const Track& agent : agents) {
    if (agent.id == kEgoId || agent.states.empty()) continue;
    const AgentState& state = agent.states.back();
    if ((state.pose.position() - ego).norm() >= radius) continue;
    const bool is_object = agent.agent_class == AgentClass::kStaticObject;
    const OrientedBox box = boxAt(agent, state.pose);
    others.push_back({box, circumradius(box.size), is_object ? 0.0 : state.velocity.norm()});
  }
  return others;
}

std::vector<OrientedBox> boxesOf(const std::vector<Other>& others) {
  std::vector<OrientedBox> boxes;
  for (const Other& other : others) boxes.push_back(other.box);
  return boxes;
}

/// Finds the lead at each step of one plan.
class LeadFinder {
 public:
  LeadFinder(const IdmPath& path, std::vector<Other> others, double width)
      : path_(path), others_(std::move(others)), corridor_(path, boxesOf(others_), width) {}

  IdmLead leadOf(const OrientedBox& ego, double progress) const {
    const std::vector<bool> touched = corridor_.touchedFrom(std::clamp(progress, 0.0, path_.end()));
    const double ego_radius = circumradius(ego.size);
    const Other* nearest = nullptr;
    // Among agents at the same distance (0 if they touch the ego), nuPlan's search
    // tree returns the one with the smallest y.
    auto least = std::make_pair(std::numeric_limits<double>::infinity(), 0.0);
    for (std::size_t i = 0; i < others_.size(); ++i) {
      const Other& other = others_[i];
      const double middles = (other.box.center.position() - ego.center.position()).norm();
      const double at_least = middles - other.radius - ego_radius - kRounding;
      if (at_least > (touched[i] ? least.first : 0.0)) continue;
      const auto place = std::make_pair(distance(ego, other.box), other.box.center.y);
      if (place >= least || !(touched[i] || place.first == 0.0)) continue;
      least = place;
      nearest = &other;
    }
    if (nearest == nullptr) return {path_.end() - progress - 0.5 * ego.size.length, 0.0};
    const double turned = angleBetween(ego.center.yaw, nearest->box.center.yaw);
    return {least.first, nearest->speed * std::cos(turned)};
  }

 private:
  const IdmPath& path_;
  std::vector<Other> others_;
  IdmCorridor corridor_;
};

}  // namespace

void IdmPlanner::initialize(const DrivingTask& task) {
  Polyline checked(task.route);
  task_ = task;
  law_ = IdmParameters();
  path_.reset();
}

void IdmPlanner::setOut(const TrajectoryPoint& ego) {
  lanes_ = laneRoute(*task_.lanes, task_.route, ego.pose, route_);
  path_.emplace(nodesOf(task_, lanes_, route_));
  law_ = options_.law;
  if (!lanes_.empty()) {
    const auto& limit = task_.lanes->map().lanes[lanes_.front()].speed_limit;
    law_.desired_speed = limit.value_or(options_.law.desired_speed);
  }
  law_.desired_speed = std::max(law_.desired_speed, ego.speed);
}

std::vector<TrajectoryPoint> IdmPlanner::plan(const Observation& observation) {
  const TrajectoryPoint& ego = observation.ego;
  if (!path_) setOut(ego);
  const std::vector<Track> agents =
      withRedLights(observation, task_.ego.size, *task_.lanes, lanes_);
  const LeadFinder finder(*path_, othersNear(agents, ego.pose.position(), options_.lead.radius),
                          task_.ego.size.width);
  IdmState state{path_->project(ego.pose.position()), ego.speed};
  OrientedBox box{ego.pose, task_.ego.size};
  std::vector<TrajectoryPoint> points = {ego};
  points.front().pose = path_->at(state.progress);
  const int steps = static_cast<int>(std::lround(options_.horizon / options_.step));
  for (int i = 1; i <= steps; ++i) {
    state = eulerStep(law_, state, finder.leadOf(box, state.progress), options_.step);
    state.speed = std::max(state.speed, 0.0);
    box.center = path_->at(state.progress);
    points.push_back(pointAfter(points.back(), options_.step, box.center, state.speed));
    points.back().time = ego.time + i * options_.step;
  }
  return points;
}

double publishedIdmSpeed(const PublishedIdmOptions& options, double speed, double lead_speed,
                         double distance) {
  const auto rate = [&](const Eigen::Vector2d& state) {
    return Eigen::Vector2d(
        state[1], plainIdmAcceleration(options.law, state[1], lead_speed, distance - state[0]));
  };
  const Integral after =
      integrateDormandPrince(rate, {0.0, speed}, options.step, options.tolerance);
  return std::max(after.state[1], 0.0);
}

void PublishedIdmPlanner::initialize(const DrivingTask& task) { route_.emplace(task.route); }

std::vector<TrajectoryPoint> PublishedIdmPlanner::plan(const Observation& observation) {
  const TrajectoryPoint& ego = observation.ego;
  double lead_speed = 0.0;
  double distance = std::numeric_limits<double>::infinity();
  for (const Track& agent : observation.agents) {
    if (agent.id != attacker_id_) continue;
    const AgentState& lead = agent.states.back();
    lead_speed = lead.velocity.norm();
    distance = (lead.pose.position() - ego.pose.position()).norm();
  }
  const double speed = publishedIdmSpeed(options_, ego.speed, lead_speed, distance);
  const double place = route_->project(ego.pose.position()).arc_length + speed * options_.step;
  return {ego, pointAfter(ego, options_.step, route_->poseAt(place), speed)};
}

}  // namespace forge
