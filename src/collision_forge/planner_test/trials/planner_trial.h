#pragma once

#include <vector>

#include "collision_forge/planner_test/trials/avoidability.h"
#include "collision_forge/planner_test/trials/rollout.h"

namespace forge {

/// Result of one planner in one crash, with the data that a figure needs.
struct PlannerTrial {
  RolloutOutcome outcome;
  Avoidability avoidability;
  std::vector<std::vector<Pose2>> proposals;  ///< Planner::proposals() of the last call
  double mean_call = 0.0;                     ///< s of the wall clock per successful call of plan()
  double max_call = 0.0;                      ///< s, the longest such call
};

/// Runs rollout() and findAvoidability(). If the setup has its own attacker policy, uses
/// findEvasion() after a hit instead; a rollout without contact then counts as avoidable, and one
/// with a failure has no result. Throws as these functions.
PlannerTrial tryPlanner(Planner& planner, const Driving& driving, const CrashScenario& scenario,
                        const RolloutSetup& setup);

}  // namespace forge
