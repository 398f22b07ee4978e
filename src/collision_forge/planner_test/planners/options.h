#pragma once

#include "collision_forge/attack/verify/options.h"
#include "collision_forge/planner_test/planners/idm.h"
#include "collision_forge/planner_test/planners/kinematic_bicycle.h"
#include "collision_forge/planner_test/planners/lqr_tracker.h"
#include "collision_forge/planner_test/planners/pdm_options.h"
#include "collision_forge/planner_test/planners/route.h"
#include "collision_forge/planner_test/planners/rule_based_options.h"
#include "collision_forge/planner_test/planners/torchscript_planner.h"

namespace forge {

class Section;

/// s; with shorter steps and intervals a test computes for minutes.
inline constexpr double kMinTimeStep = 0.01;

/// config/planners.yaml, section planning, where each number's unit and source stand.
struct PlanningOptions {
  double history = 0.0;
  double interval = 0.0;
  RouteOptions route;
};

/// config/planners.yaml, section external.
struct ExternalOptions {
  double interval = 0.0;
  double timeout = 0.0;
};

/// config/planners.yaml, a member a section, but for those of TrialOptions.
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
  RuleBasedOptions tuned_rule_based;  ///< with those that STRIVE tuned
  TorchscriptOptions torchscript;
};

/// Reads its sections of planners.yaml; `limits` are those of the ego.
void readOptions(Section& file, PlannerOptions& options, const VehicleLimits& limits);

}  // namespace forge
