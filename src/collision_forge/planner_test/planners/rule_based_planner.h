#pragma once

#include <optional>
#include <vector>

#include "collision_forge/planner_test/planners/lane_graph.h"
#include "collision_forge/planner_test/planners/planner.h"
#include "collision_forge/planner_test/planners/rule_based_choice.h"
#include "collision_forge/planner_test/planners/rule_based_options.h"

namespace forge {

/// The rule-based planner of STRIVE (Rempe et al. 2022, arXiv 2112.05077): planOnLanes() on the
/// lane graph of the task's map. From several speed profiles along its lane it takes the longest
/// one that is unlikely to collide with the predicted futures of other agents, else the least
/// likely one. Red lights are ignored.
class RuleBasedPlanner : public Planner {
 public:
  explicit RuleBasedPlanner(const RuleBasedOptions& options) : options_(options) {}

  /// As Planner::initialize(). Throws std::invalid_argument for a task without lanes and for a
  /// route without two distinct points.
  void initialize(const DrivingTask& task) override;
  /// As Planner::plan(): `steps` + 1 points, `step` seconds apart, the first at the observation's
  /// time.
  std::vector<TrajectoryPoint> plan(const Observation& observation) override;
  /// As Planner::proposals(): one pose per step for each profile of choice(); empty before the
  /// first plan().
  std::vector<std::vector<Pose2>> proposals() const override;

  /// Returns the speed profiles of the last plan() and the chosen one. Throws
  /// std::bad_optional_access before the first plan().
  const RuleBasedChoice& choice() const { return last_.value().choice; }

 private:
  RuleBasedOptions options_;
  DrivingTask task_;
  std::optional<LaneGraph> graph_;
  std::optional<Polyline> route_;  // set only with EgoWay::kAlongRoute
  std::optional<RuleBasedPlan> last_;
};

}  // namespace forge
