#pragma once

#include <optional>
#include <vector>

#include "collision_forge/planners/bent_path.h"
#include "collision_forge/planners/circle_chain.h"
#include "collision_forge/planners/planner.h"
#include "collision_forge/planners/route_centerline.h"
#include "collision_forge/planners/rule_based_futures.h"
#include "collision_forge/planners/rule_based_options.h"
#include "collision_forge/planners/speed_plan.h"

namespace forge {

/// The probability that the ego collides within a step, told from the least distance of the
/// circles' middles (m), the sum of their radii (m) and the number of steps from now: 1 when
/// circles overlap, 0 beyond the safety buffer, else 1 + tanh(-distance * weight), the weight
/// rising with the steps.
double collisionProbability(double distance, double radii, int step,
                            const RuleBasedOptions& options);

/// The rule-based planner of STRIVE (Rempe et al. 2022, arXiv 2112.05077): of several speeds along
/// the lanes of its route, the one that gets farthest with little probability of a collision with
/// what the others may do, each by itself; if there is none, the one with the least probability.
class RuleBasedPlanner : public Planner {
 public:
  /// What the ego may do, as it was weighed.
  struct Candidate {
    SpeedPlan speeds;
    double probability = 0.0;  ///< of a collision with the worst of the others' futures
  };

  RuleBasedPlanner(const RuleBasedOptions& options, const RouteCenterlineOptions& route)
      : options_(options), route_options_(route) {}

  void initialize(const DrivingTask& task) override;
  std::vector<TrajectoryPoint> plan(const Observation& observation) override;
  std::vector<std::vector<Pose2>> proposals() const override;

  /// Of the last plan(), slower ones first.
  const std::vector<Candidate>& candidates() const { return candidates_; }
  std::size_t best() const { return best_; }

 private:
  void proposeSpeeds(double speed);
  std::vector<ExpectedAgent> expectedAgents(const Observation& observation) const;
  double probabilityOf(const std::vector<PlacedChain>& ego,
                       const std::vector<ExpectedAgent>& agents) const;
  double probabilityWith(const std::vector<PlacedChain>& ego, const ExpectedAgent& agent,
                         const std::vector<PlacedChain>& future) const;
  void choose();

  RuleBasedOptions options_;
  RouteCenterlineOptions route_options_;
  DrivingTask task_;
  CircleChain chain_;
  std::optional<Polyline> way_;
  std::optional<BentPath> path_;  // of the last plan()
  std::vector<Candidate> candidates_;
  std::size_t best_ = 0;
};

}  // namespace forge
