#pragma once

#include "collision_forge/planners/idm.h"
#include "collision_forge/planners/kinematic_bicycle.h"
#include "collision_forge/planners/lqr_tracker.h"
#include "collision_forge/planners/pdm_options.h"
#include "collision_forge/planners/route.h"
#include "collision_forge/planners/rule_based_options.h"
#include "collision_forge/planners/torchscript_planner.h"
#include "collision_forge/verify/options.h"

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
