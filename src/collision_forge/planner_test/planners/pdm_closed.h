#pragma once

#include <set>
#include <string>
#include <vector>

#include "collision_forge/planner_test/planners/pdm_brake.h"
#include "collision_forge/planner_test/planners/pdm_proposals.h"
#include "collision_forge/planner_test/planners/pdm_scorer.h"

namespace forge {

/// A proposal with its simulated motion and score.
struct PdmCandidate {
  PdmProposal proposal;
  PdmMotion motion;  ///< simulated from the ego's state along the proposal
  PdmScore score;
};

/// PDM-Closed (Dauner et al. 2023, arXiv 2306.07962) on a path and a map. Creates proposals at
/// several lateral offsets and speeds with the intelligent driver model, simulates each with an LQR
/// tracker and a kinematic bicycle, and scores it against the forecasts of the other agents. The
/// plan is the best proposal itself, not its simulation.
class PdmClosed {
 public:
  /// `centerline`: path of the route, global map frame.
  PdmClosed(PdmPath centerline, const EgoVehicle& ego, const KinematicBicycleOptions& car,
            const LqrOptions& lqr, const PdmOptions& options);

  /// Plans from `start`. Returns `options.output_steps` + 1 poses of the rear axle, one every
  /// `options.step` seconds, the first at t0. `speed_limit`: m/s.
  std::vector<Pose2> plan(const BicycleState& start, const std::vector<Track>& agents,
                          const PdmMap& map, double speed_limit);

  /// Candidates of the last plan(), ordered by offset, then by speed.
  const std::vector<PdmCandidate>& candidates() const { return candidates_; }
  /// Returns the index of the candidate with the highest score, the first of equals.
  std::size_t best() const { return best_; }
  /// Returns whether the last plan() applies the emergency brake instead of the best candidate.
  bool isEmergencyBraking() const { return is_emergency_braking_; }
  /// The path of the constructor.
  const PdmPath& centerline() const { return centerline_; }

 private:
  std::vector<Pose2> chosenPoses(PdmProposer& proposer, const BicycleState& start);

  PdmPath centerline_;
  EgoVehicle ego_;
  PdmOptions options_;
  KinematicBicycle bicycle_;
  LqrTracker tracker_;
  PdmComfort comfort_;
  std::set<std::string> ignored_;  // ids of agents that the ego has touched
  std::vector<PdmCandidate> candidates_;
  std::size_t best_ = 0;
  bool is_emergency_braking_ = false;
};

}  // namespace forge
