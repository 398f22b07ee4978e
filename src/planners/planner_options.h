#pragma once

#include "planners/avoidability.h"
#include "planners/idm.h"
#include "planners/kinematic_bicycle.h"
#include "planners/lqr_tracker.h"
#include "planners/pdm_options.h"
#include "planners/rollout_options.h"
#include "planners/rule_based_options.h"

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
