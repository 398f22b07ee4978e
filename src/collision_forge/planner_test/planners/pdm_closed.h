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
  PdmProposal proposal;  ///< path and speeds before vehicle dynamics
  PdmMotion motion;      ///< simulated from the ego's state along the proposal
  PdmScore score;        ///< of `motion`, relative to the motions of the same plan()
};

/// PDM-Closed (Dauner et al. 2023, arXiv 2306.07962) on a path and a map. Creates proposals at
/// several lateral offsets and speeds with the intelligent driver model, simulates each with an LQR
/// tracker and a kinematic bicycle, and scores it against the forecasts of the other agents. The
/// plan is the best proposal itself, not its simulation.
class PdmClosed {
 public:
  /// `centerline`: path of the route, global map frame. `car`: of the simulation, which ignores its
  /// limits of acceleration and braking, as published. `lqr`: of the simulation's tracker, whose
  /// wheelbase is `options.tracker_wheelbase`. Copies all arguments.
  PdmClosed(PdmPath centerline, const EgoVehicle& ego, const KinematicBicycleOptions& car,
            const LqrOptions& lqr, const PdmOptions& options);

  /// Plans from `start`, the ego's state at t0. Returns `options.output_steps` + 1 poses of the
  /// rear axle in the global map frame, one every `options.step` seconds, the first at t0; poses do
  /// not go beyond the path's end. `agents`: other agents and red lights (withRedLights()); their
  /// newest state counts as t0. `map` is used only during the call. `speed_limit`: m/s. Agents that
  /// the ego touches at t0 are ignored in this and all later calls.
  std::vector<Pose2> plan(const BicycleState& start, const std::vector<Track>& agents,
                          const PdmMap& map, double speed_limit);

  /// Returns the candidates of the last plan(), ordered by offset, then by speed; empty before it.
  const std::vector<PdmCandidate>& candidates() const { return candidates_; }
  /// Returns the index in candidates() of the highest PdmScore::total, the first of equals; 0
  /// before the first plan().
  std::size_t best() const { return best_; }
  /// Returns whether the last plan() applies the emergency brake instead of the best candidate.
  bool isEmergencyBraking() const { return is_emergency_braking_; }
  /// The path of the constructor.
  const PdmPath& centerline() const { return centerline_; }

 private:
  /// Returns the poses of the best proposal, or of the emergency brake if it fires.
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
