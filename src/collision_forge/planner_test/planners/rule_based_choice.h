#pragma once

#include <vector>

#include "collision_forge/planner_test/planners/rule_based_futures.h"

namespace forge {

/// Returns the probability (0..1) that the ego collides within a step: 1 for a negative `gap`, else
/// 1 - tanh(gap * weight). `gap`: m to the nearest circle of another agent; infinite: 0. `step`:
/// number of steps from t0; weight = distance_weight + distance_weight_rate * step.
double collisionProbability(double gap, int step, const RuleBasedOptions& options);

/// A speed profile of the ego with its collision probability.
struct WeighedProfile {
  SpeedProfile profile;  ///< speeds and distances from t0 on
  /// m from the ego's circles to the nearest predicted ones at each step (index 0: t0), negative if
  /// they overlap; infinite if there is no other agent.
  std::vector<double> gaps;
  double probability = 0.0;  ///< 0..1, of a collision at any step: 1 minus the product of (1 -
                             ///< collisionProbability()) over all steps
};

/// All speed profiles of the ego and the index of the chosen one.
struct RuleBasedChoice {
  std::vector<WeighedProfile> profiles;  ///< in the order of speedProfiles()
  std::size_t chosen = 0;                ///< index in `profiles`
};

/// Scores every speed profile of the ego along `way` and chooses one. Takes the longest (greatest
/// distance after the last step) with a collision probability below `options.max_probability` (if
/// `is_on_lane` is false and `others` is not empty, the shortest); if none is below, the one with
/// the lowest probability. Takes the first of equals. `is_on_lane`: the ego matches an edge
/// (matchedEdges()). `others`: predicted boxes, each with a place for every step.
RuleBasedChoice chooseProfile(const DrivenBox& ego, const LaneSpline& way, bool is_on_lane,
                              const std::vector<ExpectedBox>& others,
                              const RuleBasedOptions& options);

/// Returns the ego's pose (middle of the box, global map frame) after the first step of `plan`: its
/// distance straight towards the point of `way` at that distance (straight ahead if that point is
/// on the wrong side of the ego), with the heading of `way` there. `ego`: pose at t0. `plan` must
/// have a step.
Pose2 poseAfterStep(const Pose2& ego, const LaneSpline& way, const SpeedPlan& plan);

/// Returns whether the middle of the other agent is within `options.interaction_radius` of the
/// ego's middle.
bool isNear(const Pose2& ego, const Pose2& other, const RuleBasedOptions& options);

/// Result of planOnLanes().
struct RuleBasedPlan {
  LaneSpline way;                 ///< the ego's path that was taken
  std::size_t other_futures = 0;  ///< number of predicted futures of all other agents together
  RuleBasedChoice choice;         ///< speed profiles along `way`
};

/// Runs the rule-based planner for one step. The ego takes the candidate path that stays nearest to
/// `route` (least sum of distances to it at the steps of the longest profile), or the first one if
/// `route` is null. `others`: all agents but the ego; agents that are not near (isNear()) are
/// ignored.
RuleBasedPlan planOnLanes(const DrivenBox& ego, const std::vector<DrivenBox>& others,
                          const LaneGraph& graph, const Polyline* route,
                          const RuleBasedOptions& options);

}  // namespace forge
