#pragma once

#include <vector>

#include "collision_forge/planner_test/trials/avoidability.h"
#include "collision_forge/planner_test/trials/rollout.h"

namespace forge {

/// Result of one planner in one crash, with the data that a figure needs.
struct PlannerTrial {
  RolloutOutcome outcome;                     ///< of rollout(), with its motions
  Avoidability avoidability;                  ///< of the crash; see tryPlanner()
  std::vector<std::vector<Pose2>> proposals;  ///< Planner::proposals() after the last successful
                                              ///< call of plan(); empty if there is none
  double mean_call = 0.0;  ///< s of the wall clock per successful call of plan(); 0 without calls
  double max_call = 0.0;   ///< s of the wall clock, the longest successful call
};

/// Runs rollout() and findAvoidability(). If the setup has its own attacker policy, uses
/// findEvasion() after a contact instead (only `avoidability.last` is set); a rollout without
/// contact then counts as avoidable with the motion as driven, and one with a failure as not
/// avoidable. Throws as these functions.
PlannerTrial tryPlanner(Planner& planner, const Driving& driving, const CrashScenario& scenario,
                        const RolloutSetup& setup);

}  // namespace forge
