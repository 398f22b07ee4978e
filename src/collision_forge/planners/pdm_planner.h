#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "collision_forge/planners/pdm_proposals.h"
#include "collision_forge/planners/pdm_scorer.h"
#include "collision_forge/planners/planner.h"

namespace forge {

/// PDM-Closed (Dauner et al. 2023, arXiv 2306.07962): proposals along the centreline of the route
/// at several offsets and speeds, each driven by IDM, simulated with an LQR tracker and a kinematic
/// bicycle, and scored against the others' forecasts; the best is driven on.
class PdmPlanner : public Planner {
 public:
  /// A proposal as it was weighed.
  struct Candidate {
    double lateral_offset = 0.0;  ///< m left of the route's centreline
    double desired_speed = 0.0;   ///< m/s
    PdmMotion motion;
    PdmScore score;
  };

  PdmPlanner(const PdmOptions& options, const RouteCenterlineOptions& route,
             const KinematicBicycleOptions& bicycle, const LqrOptions& lqr);

  void initialize(const DrivingTask& task) override;
  std::vector<TrajectoryPoint> plan(const Observation& observation) override;
  std::vector<std::vector<Pose2>> proposals() const override;

  /// Of the last plan(), in the order of the offsets, then of the speeds.
  const std::vector<Candidate>& candidates() const { return candidates_; }
  /// Index of the best of these, the first of equals.
  std::size_t best() const { return best_; }
  /// True when the last plan() brakes instead of driving the best candidate.
  bool isEmergencyBraking() const { return is_emergency_braking_; }

 private:
  void propose(PdmProposer& proposer, const BicycleState& start, double arc_length);
  void score(const PdmScorer& scorer);
  PdmMotion chosenMotion(PdmProposer& proposer, const BicycleState& start, double arc_length);

  PdmOptions options_;
  RouteCenterlineOptions route_options_;
  KinematicBicycleOptions bicycle_options_;
  KinematicBicycle bicycle_;
  LqrOptions lqr_options_;
  LqrTracker tracker_;
  DrivingTask task_;
  std::optional<SampledWay> way_;
  std::optional<std::size_t> way_sample_;  // where the ego was on the way at the last plan()
  std::set<std::string> ignored_;          // ids of agents that the ego has touched
  std::vector<Candidate> candidates_;
  std::size_t best_ = 0;
  bool is_emergency_braking_ = false;
};

}  // namespace forge
