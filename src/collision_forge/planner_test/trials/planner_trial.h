#pragma once

#include <vector>

#include "collision_forge/planner_test/trials/avoidability.h"
#include "collision_forge/planner_test/trials/rollout.h"

namespace forge {

/// One planner in one crash, with what a picture of it needs.
struct PlannerTrial {
  RolloutOutcome outcome;
  Avoidability avoidability;
  std::vector<std::vector<Pose2>> proposals;  ///< Planner::proposals() of the last call
  double mean_call = 0.0;                     ///< s of the wall clock in an answered call of plan()
  double max_call = 0.0;
};

/// rollout() and findAvoidability(). Where the setup has an attacker of its own, findEscape() from
/// the contact; what drove on without one is avoidable by that, and of a failure nothing is known.
/// Throws as they do.
PlannerTrial tryPlanner(Planner& planner, const Driving& driving, const CrashScenario& scenario,
                        const RolloutSetup& setup);

}  // namespace forge
