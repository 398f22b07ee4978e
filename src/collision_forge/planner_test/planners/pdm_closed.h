#pragma once

#include <set>
#include <string>
#include <vector>

#include "collision_forge/planner_test/planners/pdm_brake.h"
#include "collision_forge/planner_test/planners/pdm_proposals.h"
#include "collision_forge/planner_test/planners/pdm_scorer.h"

namespace forge {

/// A proposal as it was weighed.
struct PdmCandidate {
  PdmProposal proposal;
  PdmMotion motion;  ///< simulated from the ego's state along the proposal
  PdmScore score;
};

/// PDM-Closed (Dauner et al. 2023, arXiv 2306.07962) on a path and a map: proposals at several
/// offsets and speeds, each driven by IDM, simulated with an LQR tracker and a kinematic bicycle,
/// and scored against the others' forecasts. Given out are the poses of the best proposal, not of
/// its simulation.
class PdmClosed {
 public:
  PdmClosed(PdmPath centerline, const EgoVehicle& ego, const KinematicBicycleOptions& car,
            const LqrOptions& lqr, const PdmOptions& options);

  /// Poses of the rear axle, one every options.step, options.output_steps + 1 in all.
  std::vector<Pose2> plan(const BicycleState& start, const std::vector<Track>& agents,
                          const PdmMap& map, double speed_limit);

  /// Of the last plan(), in the order of the offsets, then of the speeds.
  const std::vector<PdmCandidate>& candidates() const { return candidates_; }
  /// Index of the best of these, the first of equals.
  std::size_t best() const { return best_; }
  /// True when the last plan() brakes instead of driving the best candidate.
  bool isEmergencyBraking() const { return is_emergency_braking_; }
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
