#include "collision_forge/planners/idm.h"

#include <algorithm>
#include <cmath>

namespace forge {
namespace {

/// A vehicle that the law drives along a path.
struct Driver {
  double arc_length = 0.0;  ///< m
  double speed = 0.0;       ///< m/s
  double acceleration = 0.0;

  /// Stops at a standstill.
  void advance(double demanded, double step) {
    const double next = std::max(speed + demanded * step, 0.0);
    acceleration = (next - speed) / step;
    arc_length += 0.5 * (speed + next) * step;
    speed = next;
  }
};

/// After `before`; the curvature is that of the way in between.
TrajectoryPoint nextPoint(const TrajectoryPoint& before, const Driver& driver, const Polyline& path,
                          double time) {
  constexpr double kStanding = 0.01;  // m; a shorter way has no curvature
  TrajectoryPoint point{time, path.poseAt(driver.arc_length), driver.speed, driver.acceleration,
                        0.0};
  const double driven = (point.pose.position() - before.pose.position()).norm();
  if (driven > kStanding) point.curvature = angleBetween(before.pose.yaw, point.pose.yaw) / driven;
  return point;
}

}  // namespace

void IdmPlanner::initialize(const DrivingTask& task) {
  route_.emplace(task.route);
  size_ = task.ego.size;
}

std::vector<TrajectoryPoint> IdmPlanner::plan(const Observation& observation) {
  const TrajectoryPoint& ego = observation.ego;
  const double start = route_->project(ego.pose.position()).arc_length;
  const auto lead = findLead({*route_, start, size_}, kEgoId, observation.agents, options_.lead);
  Driver driver{start, ego.speed, 0.0};
  std::vector<TrajectoryPoint> points = {ego};
  const int steps = static_cast<int>(std::lround(options_.horizon / options_.step));
  for (int i = 0; i < steps; ++i) {
    double demanded = idmFreeAcceleration(options_.law, driver.speed);
    if (lead) {
      const double gap = lead->gap + lead->speed * i * options_.step - (driver.arc_length - start);
      demanded =
          idmAcceleration(options_.law, driver.speed, lead->speed, std::max(gap, kTouchingGap));
    }
    driver.advance(demanded, options_.step);
    points.push_back(nextPoint(points.back(), driver, *route_, ego.time + (i + 1) * options_.step));
  }
  return points;
}

void PublishedIdmPlanner::initialize(const DrivingTask& task) { route_.emplace(task.route); }

std::vector<TrajectoryPoint> PublishedIdmPlanner::plan(const Observation& observation) {
  const TrajectoryPoint& ego = observation.ego;
  double demanded = idmFreeAcceleration(options_.law, ego.speed);
  for (const Track& agent : observation.agents) {
    if (agent.id != attacker_id_) continue;
    const AgentState& lead = agent.states.back();
    const double distance = (lead.pose.position() - ego.pose.position()).norm();
    demanded = idmAcceleration(options_.law, ego.speed, lead.velocity.norm(),
                               std::max(distance, kTouchingGap));
  }
  Driver driver{route_->project(ego.pose.position()).arc_length, ego.speed, 0.0};
  driver.advance(demanded, options_.step);
  return {ego, nextPoint(ego, driver, *route_, ego.time + options_.step)};
}

}  // namespace forge
