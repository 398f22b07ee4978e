#pragma once

#include <optional>
#include <vector>

#include "collision_forge/planner_test/planners/lane_graph.h"
#include "collision_forge/planner_test/planners/planner.h"
#include "collision_forge/planner_test/planners/rule_based_choice.h"
#include "collision_forge/planner_test/planners/rule_based_options.h"

namespace forge {

/// The rule-based planner of STRIVE (Rempe et al. 2022, arXiv 2112.05077): of several speeds along
/// its lane, the one that gets farthest with little probability of a collision with what the others
/// may do; if there is none, the one with the least probability. planOnLanes() on the lane graph of
/// the task's map.
class RuleBasedPlanner : public Planner {
 public:
  explicit RuleBasedPlanner(const RuleBasedOptions& options) : options_(options) {}

  void initialize(const DrivingTask& task) override;
  std::vector<TrajectoryPoint> plan(const Observation& observation) override;
  std::vector<std::vector<Pose2>> proposals() const override;

  /// The profiles of the last plan(), and which was taken. Throws std::bad_optional_access before.
  const RuleBasedChoice& choice() const { return last_.value().choice; }

 private:
  RuleBasedOptions options_;
  DrivingTask task_;
  std::optional<LaneGraph> graph_;
  std::optional<Polyline> route_;  // where it is followed
  std::optional<RuleBasedPlan> last_;
};

}  // namespace forge
