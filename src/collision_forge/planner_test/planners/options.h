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
  double history = 0.0;   ///< s of past states that an Observation has of each agent, at most
  double interval = 0.0;  ///< s of scene time between two calls of plan(), for idm and pdm
  RouteOptions route;     ///< of routeOf(); not in the file
};

/// Options of all planners: config/planners.yaml. A member without a section of the file keeps its
/// defaults.
struct PlannerOptions {
  PlanningOptions planning;                 ///< section planning
  IdmOptions idm;                           ///< section idm.standard
  PublishedIdmOptions published_idm;        ///< section idm.published
  ExternalOptions external;                 ///< section external
  KinematicBicycleOptions car;              ///< section car, and vehicle_limits.yaml
  LqrOptions lqr;                           ///< no section
  RouteCenterlineOptions route_centerline;  ///< no section
  PdmOptions pdm;                           ///< section pdm
  RuleBasedOptions rule_based;              ///< section rule_based, with the published parameters
  RuleBasedOptions tuned_rule_based;  ///< section rule_based, with the parameters that STRIVE tuned
  TorchscriptOptions torchscript;     ///< section torchscript
};

/// Reads the sections of PlannerOptions from planners.yaml; `limits`: the strict limits of
/// vehicle_limits.yaml, for `car`. Throws ConfigError for a missing, malformed or out-of-range
/// value.
void readOptions(Section& file, PlannerOptions& options, const VehicleLimits& limits);

}  // namespace forge
