#pragma once

#include "collision_forge/planner_test/planners/options.h"
#include "collision_forge/planner_test/trials/avoidability.h"
#include "collision_forge/planner_test/trials/contact_judgement.h"
#include "collision_forge/planner_test/trials/nuplan_score.h"

namespace forge {

/// config/planners.yaml, section rollout, where unit and source of its key stand.
struct RolloutOptions {
  double step = 0.0;
  double hard_braking = PdmComfortOptions().max_braking;  ///< m/s2
  FaultOptions fault;
};

/// config/planners.yaml, section until_hit.
struct UntilHitOptions {
  int tries = 0;
  double min_impact_speed = 0.0;
};

/// config/planners.yaml: the planners, and how they are tried.
struct TrialOptions : PlannerOptions {
  /// Of the others with Background::kIdm: `idm` of the file, whatever planner or variant is tested.
  IdmOptions traffic;
  RolloutOptions rollout;
  NuplanScoreOptions nuplan_score;
  AvoidabilityOptions avoidability;
  UntilHitOptions until_hit;
};

/// Reads all of planners.yaml; `limits` are those of the ego. Throws ConfigError for a missing,
/// unknown or malformed key.
void readOptions(Section& file, TrialOptions& options, const VehicleLimits& limits);

}  // namespace forge
