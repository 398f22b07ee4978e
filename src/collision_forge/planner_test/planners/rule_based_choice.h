#pragma once

#include <vector>

#include "collision_forge/planner_test/planners/rule_based_futures.h"

namespace forge {

/// The probability that the ego collides within a step, told from the gap to the nearest circle of
/// the others (m) and the number of steps from now: 1 where circles overlap, else 1 +
/// tanh(-gap * weight), the weight rising with the steps.
double collisionProbability(double gap, int step, const RuleBasedOptions& options);

/// A speed profile of the ego as it was weighed.
struct WeighedProfile {
  SpeedProfile profile;
  std::vector<double> gaps;  ///< m to the nearest of all futures, one a step; infinite for none
  double probability = 0.0;  ///< of a collision at any step
};

/// What the ego chose from.
struct RuleBasedChoice {
  std::vector<WeighedProfile> profiles;
  std::size_t chosen = 0;
};

/// Weighs every profile of the ego on its way. Chosen is the farthest of those with little
/// probability of a collision; for an ego that matches no lane the shortest of them, unless nobody
/// is expected; where there is none, the one with the least probability. Of equals the first.
RuleBasedChoice chooseProfile(const DrivenBox& ego, const LaneSpline& way, bool is_on_lane,
                              const std::vector<ExpectedBox>& others,
                              const RuleBasedOptions& options);

/// Where the ego is after one step of a profile: as far as the step takes it, straight towards the
/// place on its way as far on, or straight on where that place does not lie on that side of it.
/// It heads as the way does there.
Pose2 poseAfterStep(const Pose2& ego, const LaneSpline& way, const SpeedPlan& plan);

/// Whether somebody is near enough to be looked at.
bool isNear(const Pose2& ego, const Pose2& other, const RuleBasedOptions& options);

/// The planner on a lane graph.
struct RuleBasedPlan {
  LaneSpline way;                 ///< the ego's
  std::size_t other_futures = 0;  ///< of all others together
  RuleBasedChoice choice;
};

/// `route` is the way that the ego is meant to take; it drives that of its ways which stays nearest
/// to it. Without a route it drives the first.
RuleBasedPlan planOnLanes(const DrivenBox& ego, const std::vector<DrivenBox>& others,
                          const LaneGraph& graph, const Polyline* route,
                          const RuleBasedOptions& options);

}  // namespace forge
