#pragma once

#include <vector>

#include "collision_forge/planner_test/planners/rule_based_futures.h"

namespace forge {

/// Returns the probability that the ego collides within a step: 1 for a negative `gap`, else 1 +
/// tanh(-gap * weight). `gap`: m to the nearest circle of another agent. `step`: number of steps
/// from t0; the weight increases with it.
double collisionProbability(double gap, int step, const RuleBasedOptions& options);

/// A speed profile of the ego with its collision probability.
struct WeighedProfile {
  SpeedProfile profile;
  std::vector<double>
      gaps;  ///< m to the nearest predicted box at each step; infinite if there is none
  double probability = 0.0;  ///< of a collision at any step
};

/// All speed profiles of the ego and the index of the chosen one.
struct RuleBasedChoice {
  std::vector<WeighedProfile> profiles;
  std::size_t chosen = 0;
};

/// Scores every speed profile of the ego along `way` and chooses one. Takes the longest with a
/// collision probability below `options.max_probability` (an ego off the lanes takes the shortest,
/// if `others` is not empty); if none is below, the one with the lowest probability. Takes the
/// first of equals.
RuleBasedChoice chooseProfile(const DrivenBox& ego, const LaneSpline& way, bool is_on_lane,
                              const std::vector<ExpectedBox>& others,
                              const RuleBasedOptions& options);

/// Returns the ego's pose after the first step of `plan`: its distance straight towards the point
/// of `way` at that distance (straight ahead if that point is on the wrong side of the ego), with
/// the heading of `way` there.
Pose2 poseAfterStep(const Pose2& ego, const LaneSpline& way, const SpeedPlan& plan);

/// Returns whether the other agent is within `options.interaction_radius` of the ego.
bool isNear(const Pose2& ego, const Pose2& other, const RuleBasedOptions& options);

/// Result of planOnLanes().
struct RuleBasedPlan {
  LaneSpline way;                 ///< the ego's path
  std::size_t other_futures = 0;  ///< number of predicted futures of all other agents together
  RuleBasedChoice choice;
};

/// Runs the rule-based planner for one step. The ego takes the candidate path that stays nearest to
/// `route`, or the first one if `route` is null.
RuleBasedPlan planOnLanes(const DrivenBox& ego, const std::vector<DrivenBox>& others,
                          const LaneGraph& graph, const Polyline* route,
                          const RuleBasedOptions& options);

}  // namespace forge
