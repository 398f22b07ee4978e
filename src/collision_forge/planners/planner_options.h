#pragma once

#include "collision_forge/planners/idm.h"
#include "collision_forge/planners/kinematic_bicycle.h"
#include "collision_forge/planners/lqr_tracker.h"
#include "collision_forge/planners/pdm_options.h"
#include "collision_forge/planners/rule_based_options.h"
#include "collision_forge/trials/avoidability.h"
#include "collision_forge/trials/rollout_options.h"

namespace forge {

/// config/planners.yaml, a member a section.
struct PlannerOptions {
  PlanningOptions planning;
  IdmOptions idm;
  PublishedIdmOptions published_idm;
  ExternalOptions external;
  RolloutOptions rollout;
  AvoidabilityOptions avoidability;
  KinematicBicycleOptions bicycle;
  LqrOptions lqr;
  RouteCenterlineOptions route_centerline;
  PdmOptions pdm;
  RuleBasedOptions rule_based;        ///< with the published parameters
  RuleBasedOptions tuned_rule_based;  ///< with those that STRIVE tuned
};

}  // namespace forge
