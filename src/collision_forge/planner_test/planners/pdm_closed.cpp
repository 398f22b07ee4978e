#include "collision_forge/planner_test/planners/pdm_closed.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace forge {
namespace {

/// The published simulation limits only the steering angle.
KinematicBicycleOptions unbounded(KinematicBicycleOptions car) {
  car.max_acceleration = std::numeric_limits<double>::infinity();
  car.max_braking = std::numeric_limits<double>::infinity();
  return car;
}

int forecastSteps(const PdmOptions& options) {
  const std::vector<double>& times = options.scoring.ttc_times;
  const double farthest = *std::max_element(times.begin(), times.end());
  const int looked_ahead = static_cast<int>(std::lround(farthest / options.step));
  return std::max(options.output_steps, options.proposal_steps + looked_ahead);
}

}  // namespace

PdmClosed::PdmClosed(PdmPath centerline, const EgoVehicle& ego, const KinematicBicycleOptions& car,
                     const LqrOptions& lqr, const PdmOptions& options)
    : centerline_(std::move(centerline)),
      ego_(ego),
      options_(options),
      bicycle_(unbounded(car)),
      tracker_(lqr, options.tracker_wheelbase, SpeedFit::kAcceleration),
      comfort_(options.proposal_steps + 1, options.step, options.scoring.comfort) {}

std::vector<Pose2> PdmClosed::plan(const BicycleState& start, const std::vector<Track>& agents,
                                   const PdmMap& map, double speed_limit) {
  const OrientedBox box{boxMiddleOf(start.rear_axle, ego_.center_offset), ego_.size};
  const PdmForecast forecast(agents, box, options_.step, forecastSteps(options_), options_.agents,
                             ignored_);
  PdmProposer proposer(centerline_, start.rear_axle, start.speed, forecast, ego_, options_);
  const std::vector<PdmProposal> proposals = proposer.propose(speed_limit);
  std::vector<PdmMotion> motions;
  for (const PdmProposal& proposal : proposals) {
    motions.push_back(
        simulate(start, proposer.poses(proposal), bicycle_, tracker_, options_.step, ego_));
  }
  const PdmScorer scorer({forecast, map, centerline_, comfort_}, options_.scoring);
  const std::vector<PdmScore> scores = scorer.score(motions);
  candidates_.clear();
  best_ = 0;
  for (std::size_t i = 0; i < scores.size(); ++i) {
    candidates_.push_back({proposals[i], std::move(motions[i]), scores[i]});
    if (scores[i].total > scores[best_].total) best_ = i;
  }
  return chosenPoses(proposer, start);
}

std::vector<Pose2> PdmClosed::chosenPoses(PdmProposer& proposer, const BicycleState& start) {
  const PdmBrakeOptions& brake = options_.emergency_brake;
  const PdmCandidate& best = candidates_[best_];
  is_emergency_braking_ = firesBrake(start.speed, best.score.collision_time, brake);
  if (is_emergency_braking_) {
    const double acceleration =
        centerAcceleration(start, bicycle_.curvature(start), ego_.center_offset);
    return brakePoses(start.rear_axle, brakeSpeed(start.speed, acceleration, brake),
                      options_.output_steps, options_.step);
  }
  PdmProposal proposal = best.proposal;
  proposer.extend(proposal, options_.output_steps);
  return proposer.poses(proposal);
}

}  // namespace forge
