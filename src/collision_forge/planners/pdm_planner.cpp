#include "collision_forge/planners/pdm_planner.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace forge {

PdmPlanner::PdmPlanner(const PdmOptions& options, const RouteCenterlineOptions& route,
                       const KinematicBicycleOptions& bicycle, const LqrOptions& lqr)
    : options_(options),
      route_options_(route),
      bicycle_options_(bicycle),
      bicycle_(bicycle),
      lqr_options_(lqr),
      tracker_(lqr, bicycle.wheelbase) {}

void PdmPlanner::initialize(const DrivingTask& task) {
  if (!task.lanes) throw std::invalid_argument("a driving task needs lanes");
  task_ = task;
  bicycle_options_.wheelbase = task.wheelbase;
  bicycle_ = KinematicBicycle(bicycle_options_);
  tracker_ = LqrTracker(lqr_options_, task.wheelbase);
  way_.emplace(routeCenterline(*task.lanes, task.route, route_options_));
  way_sample_.reset();
  ignored_.clear();
}

std::vector<TrajectoryPoint> PdmPlanner::plan(const Observation& observation) {
  const EgoVehicle& ego = task_.ego;
  const BicycleState start = bicycle_.stateOf(observation.ego, ego.center_offset);
  const Vector2 rear_axle = start.rear_axle.position();
  const SampledWay::Projection place =
      way_sample_ ? way_->project(rear_axle, *way_sample_) : way_->project(rear_axle);
  way_sample_ = place.sample;

  const double ttc_horizon =
      *std::max_element(options_.scoring.ttc_times.begin(), options_.scoring.ttc_times.end());
  const int forecast_steps = std::max(
      options_.output_steps,
      options_.proposal_steps + static_cast<int>(std::lround(ttc_horizon / options_.step)));
  const PdmForecast forecast(observation.agents, {observation.ego.pose, ego.size}, options_.step,
                             forecast_steps, options_.agents, ignored_);
  PdmProposer proposer(*way_, forecast, ego, bicycle_options_.max_braking, options_);
  const PdmScorer scorer(
      {forecast, *task_.lanes, *way_, place.sample, ego, bicycle_, observation.ego.pose},
      options_.map_radius, options_.scoring);
  propose(proposer, start, place.arc_length);
  score(scorer);

  const PdmMotion motion = chosenMotion(proposer, start, place.arc_length);
  std::vector<TrajectoryPoint> points;
  for (std::size_t i = 0; i < motion.states.size(); ++i) {
    const double time = observation.ego.time + static_cast<double>(i) * options_.step;
    points.push_back(bicycle_.pointOf(motion.states[i], time, ego.center_offset));
  }
  return points;
}

std::vector<std::vector<Pose2>> PdmPlanner::proposals() const {
  std::vector<std::vector<Pose2>> proposals;
  for (const Candidate& candidate : candidates_) {
    std::vector<Pose2>& poses = proposals.emplace_back();
    for (const OrientedBox& box : candidate.motion.boxes) poses.push_back(box.center);
  }
  return proposals;
}

void PdmPlanner::propose(PdmProposer& proposer, const BicycleState& start, double arc_length) {
  candidates_.clear();
  for (const double offset : options_.lateral_offsets) {
    for (const double share : options_.speed_shares) {
      const double desired_speed = share * options_.speed_limit;
      const PdmProposal proposal =
          proposer.propose(arc_length, start.speed, offset, desired_speed, options_.proposal_steps);
      candidates_.push_back(
          {offset,
           desired_speed,
           simulate(start, proposer.poses(proposal), bicycle_, tracker_, options_.step, task_.ego),
           {}});
    }
  }
}

void PdmPlanner::score(const PdmScorer& scorer) {
  std::vector<PdmMotion> motions;
  for (Candidate& candidate : candidates_) motions.push_back(std::move(candidate.motion));
  const std::vector<PdmScore> scores = scorer.score(motions);
  best_ = 0;
  for (std::size_t i = 0; i < scores.size(); ++i) {
    candidates_[i].motion = std::move(motions[i]);
    candidates_[i].score = scores[i];
    if (scores[i].total > scores[best_].total) best_ = i;
  }
}

PdmMotion PdmPlanner::chosenMotion(PdmProposer& proposer, const BicycleState& start,
                                   double arc_length) {
  const Candidate& best = candidates_[best_];
  const PdmBrakeOptions& brake = options_.emergency_brake;
  const std::optional<double>& collision = best.score.collision.time;
  is_emergency_braking_ =
      collision && *collision <= brake.max_time && start.speed <= brake.max_speed;
  if (is_emergency_braking_) {
    return simulateBraking(start, brake.braking, options_.output_steps, bicycle_, options_.step,
                           task_.ego);
  }
  const PdmProposal proposal = proposer.propose(arc_length, start.speed, best.lateral_offset,
                                                best.desired_speed, options_.output_steps);
  return simulate(start, proposer.poses(proposal), bicycle_, tracker_, options_.step, task_.ego);
}

}  // namespace forge
