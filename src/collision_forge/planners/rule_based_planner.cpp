#include "collision_forge/planners/rule_based_planner.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace forge {
namespace {

/// The pose of a path every step, and beside it the curvature there.
std::vector<TrajectoryPoint> pointsAlong(const BentPath& path, const SpeedPlan& plan,
                                         const TrajectoryPoint& now, double step, double spacing) {
  std::vector<TrajectoryPoint> points = {now};
  points.front().acceleration = plan.accelerations.front();
  for (std::size_t i = 1; i < plan.distances.size(); ++i) {
    const Pose2 pose = path.at(plan.distances[i]);
    const double turned = angleBetween(pose.yaw, path.at(plan.distances[i] + spacing).yaw);
    points.push_back({now.time + static_cast<double>(i) * step, pose, plan.speeds[i],
                      plan.accelerations[i], turned / spacing});
  }
  return points;
}

}  // namespace

double collisionProbability(double distance, double radii, int step,
                            const RuleBasedOptions& options) {
  if (distance <= radii) return 1.0;
  if (distance > options.safety_buffer) return 0.0;
  const double weight = options.distance_weight + options.distance_weight_rate * step;
  return 1.0 + std::tanh(-distance * weight);
}

void RuleBasedPlanner::initialize(const DrivingTask& task) {
  if (!task.lanes) throw std::invalid_argument("a driving task needs lanes");
  task_ = task;
  chain_ = circlesOf(task.ego.size, options_.circles);
  way_.emplace(routeCenterline(*task.lanes, task.route, route_options_));
  candidates_.clear();
}

std::vector<TrajectoryPoint> RuleBasedPlanner::plan(const Observation& observation) {
  const Vector2 here = observation.ego.pose.position();
  const BentPath& path = path_.emplace(*way_, way_->project(here).arc_length, here,
                                       options_.bend_length, options_.sample_spacing);
  proposeSpeeds(std::max(observation.ego.speed, 0.0));
  const std::vector<ExpectedAgent> agents = expectedAgents(observation);
  for (Candidate& candidate : candidates_) {
    std::vector<PlacedChain> ego;
    for (const double distance : candidate.speeds.distances) {
      ego.push_back(placed(chain_, path.at(distance)));
    }
    candidate.probability = probabilityOf(ego, agents);
  }
  choose();
  return pointsAlong(path, candidates_[best_].speeds, observation.ego, options_.step,
                     options_.sample_spacing);
}

std::vector<std::vector<Pose2>> RuleBasedPlanner::proposals() const {
  std::vector<std::vector<Pose2>> proposals;
  for (const Candidate& candidate : candidates_) {
    std::vector<Pose2>& poses = proposals.emplace_back();
    for (const double distance : candidate.speeds.distances) poses.push_back(path_->at(distance));
  }
  return proposals;
}

void RuleBasedPlanner::proposeSpeeds(double speed) {
  const double change = 0.5 * options_.step * options_.steps * options_.max_acceleration;
  const auto reachable = [&](double from, int count) {
    const double low = std::max(from - change, 0.0);
    return spread(low, std::max(low, std::min(from + change, options_.max_speed)), count);
  };
  candidates_.clear();
  for (const double middle : reachable(speed, options_.middle_speeds)) {
    for (const double end : reachable(middle, options_.end_speeds)) {
      candidates_.push_back({planThrough(speed, middle, end, options_.max_acceleration,
                                         options_.step, options_.steps),
                             0.0});
    }
  }
}

std::vector<ExpectedAgent> RuleBasedPlanner::expectedAgents(const Observation& observation) const {
  std::vector<ExpectedAgent> agents;
  for (const Track& track : observation.agents) {
    if (track.states.empty()) continue;
    const Vector2 offset = track.states.back().pose.position() - observation.ego.pose.position();
    if (offset.norm() > options_.interaction_radius) continue;
    agents.push_back(expectedAgent(track, *task_.lanes, options_));
  }
  return agents;
}

double RuleBasedPlanner::probabilityOf(const std::vector<PlacedChain>& ego,
                                       const std::vector<ExpectedAgent>& agents) const {
  double worst = 0.0;
  for (const ExpectedAgent& agent : agents) {
    for (const std::vector<PlacedChain>& future : agent.futures) {
      worst = std::max(worst, probabilityWith(ego, agent, future));
    }
  }
  return worst;
}

double RuleBasedPlanner::probabilityWith(const std::vector<PlacedChain>& ego,
                                         const ExpectedAgent& agent,
                                         const std::vector<PlacedChain>& future) const {
  const double radii = chain_.radius + agent.chain.radius;
  const double reach = chain_.reach + agent.chain.reach + std::max(radii, options_.safety_buffer);
  double missed = 1.0;
  for (std::size_t i = 0; i < ego.size(); ++i) {
    if ((ego[i].middle - future[i].middle).squaredNorm() > reach * reach) continue;
    missed *= 1.0 - collisionProbability(centerDistance(ego[i], future[i]), radii,
                                         static_cast<int>(i), options_);
  }
  return 1.0 - missed;
}

void RuleBasedPlanner::choose() {
  best_ = 0;
  const auto isSafe = [&](const Candidate& candidate) {
    return candidate.probability < options_.max_probability;
  };
  for (std::size_t i = 1; i < candidates_.size(); ++i) {
    const Candidate& candidate = candidates_[i];
    const Candidate& best = candidates_[best_];
    const bool is_better = isSafe(candidate) ? !isSafe(best) || candidate.speeds.distances.back() >
                                                                    best.speeds.distances.back()
                                             : candidate.probability < best.probability;
    if (is_better) best_ = i;
  }
}

}  // namespace forge
