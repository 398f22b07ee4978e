#pragma once

#include <vector>

#include "collision_forge/trials/avoidability.h"
#include "collision_forge/trials/rollout.h"

namespace forge {

/// One planner in one crash, with what a picture of it needs.
struct PlannerTrial {
  RolloutOutcome outcome;
  Avoidability avoidability;
  std::vector<std::vector<Pose2>> proposals;  ///< Planner::proposals() of the last call
  double mean_call = 0.0;                     ///< s of the wall clock in an answered call of plan()
  double max_call = 0.0;
};

/// rollout() and findAvoidability(), or findEscape() where the setup's attacker has hit the ego;
/// one that it escaped is avoidable by what it drove. Throws as they do.
PlannerTrial tryPlanner(Planner& planner, const Driving& driving, const CrashScenario& scenario,
                        const RolloutSetup& setup);

}  // namespace forge
