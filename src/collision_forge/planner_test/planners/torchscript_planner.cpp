#include "collision_forge/planner_test/planners/torchscript_planner.h"

#include <algorithm>
#include <utility>

#include "collision_forge/planner_test/planners/planner_contract.h"

namespace forge {
namespace {

/// Calls `ask` and converts a WorkerTimeout to a PlannerTimeout.
template <typename Ask>
void inTime(const Ask& ask) {
  try {
    ask();
  } catch (const WorkerTimeout& error) {
    throw PlannerTimeout(error.what());
  }
}

/// Returns the point one pose step after `before`, with the motion in between.
TrajectoryPoint nextPoint(const TrajectoryPoint& before, const Pose2& pose) {
  constexpr double kStanding = 0.01;  // m; a shorter displacement has no curvature
  TrajectoryPoint point{before.time + kContractPoseStep, pose, 0.0, 0.0, 0.0};
  const Vector2 driven = pose.position() - before.pose.position();
  point.speed = driven.dot(interpolate(before.pose, pose, 0.5).heading()) / kContractPoseStep;
  point.acceleration = (point.speed - before.speed) / kContractPoseStep;
  if (driven.norm() > kStanding) {
    point.curvature = angleBetween(before.pose.yaw, pose.yaw) / driven.norm();
  }
  return point;
}

}  // namespace

TorchscriptPlanner::TorchscriptPlanner(const TorchscriptOptions& options,
                                       const RouteCenterlineOptions& route)
    : options_(options),
      route_options_(route),
      worker_(options.workers->take(options, workerKey(options))) {}

TorchscriptPlanner::~TorchscriptPlanner() { options_.workers->giveBack(std::move(worker_)); }

void TorchscriptPlanner::initialize(const DrivingTask& task) {
  inputs_.emplace(task, route_options_);
  history_.clear();
  inTime([&] { worker_->begin(); });
}

std::vector<TrajectoryPoint> TorchscriptPlanner::plan(const Observation& observation) {
  const TrajectoryPoint& ego = observation.ego;
  remember(ego);
  std::vector<float> poses;
  inTime([&] { poses = worker_->plan(inputs_->at(history_, observation.agents)); });
  std::vector<TrajectoryPoint> points = {ego};
  for (std::size_t i = 0; i < poses.size(); i += kContractPoseNumbers) {
    const Pose2 local{poses[i], poses[i + 1], poses[i + 2]};
    points.push_back(nextPoint(points.back(), compose(ego.pose, local)));
  }
  return points;
}

void TorchscriptPlanner::remember(const TrajectoryPoint& ego) {
  history_.push_back(ego);
  const double oldest = ego.time - kContractFrameStep * static_cast<double>(kContractFrames);
  const auto kept =
      std::find_if(history_.begin(), history_.end(),
                   [&](const TrajectoryPoint& point) { return point.time >= oldest; });
  history_.erase(history_.begin(), kept);
}

}  // namespace forge
