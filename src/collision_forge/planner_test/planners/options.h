#pragma once

#include "collision_forge/attack/verify/options.h"
#include "collision_forge/planner_test/planners/idm.h"
#include "collision_forge/planner_test/planners/kinematic_bicycle.h"
#include "collision_forge/planner_test/planners/lqr_tracker.h"
#include "collision_forge/planner_test/planners/pdm_options.h"
#include "collision_forge/planner_test/planners/planner_process.h"
#include "collision_forge/planner_test/planners/route.h"
#include "collision_forge/planner_test/planners/rule_based_options.h"
#include "collision_forge/planner_test/planners/torchscript_planner.h"

namespace forge {

class Section;

/// Smallest time step and interval that options may have, s; a test with shorter ones takes
/// minutes.
inline constexpr double kMinTimeStep = 0.01;

/// How planners are called: config/planners.yaml, section planning, where each number's source
/// stands.
struct PlanningOptions {
  double history = 0.0;   ///< s of past states in an Observation
  double interval = 0.0;  ///< s between two calls
  RouteOptions route;
};

/// All planners: config/planners.yaml, one member per section, except for the sections in
/// TrialOptions.
struct PlannerOptions {
  PlanningOptions planning;
  IdmOptions idm;
  PublishedIdmOptions published_idm;
  ExternalOptions external;
  KinematicBicycleOptions car;
  LqrOptions lqr;
  RouteCenterlineOptions route_centerline;
  PdmOptions pdm;
  RuleBasedOptions rule_based;        ///< with the published parameters
  RuleBasedOptions tuned_rule_based;  ///< with the parameters that STRIVE tuned
  TorchscriptOptions torchscript;
};

/// Reads the sections of PlannerOptions from planners.yaml; `limits` are the ego's. Throws
/// ConfigError.
void readOptions(Section& file, PlannerOptions& options, const VehicleLimits& limits);

}  // namespace forge
