#pragma once

#include <map>
#include <string>

#include "collision_forge/planners/route.h"
#include "collision_forge/trials/contact_judgement.h"

namespace forge {

/// config/planners.yaml, section planning, where each number's unit and source stand.
struct PlanningOptions {
  std::map<std::string, double> intervals;  ///< by name of the planner
  double history = 0.0;
  RouteOptions route;
};

/// config/planners.yaml, section rollout.
struct RolloutOptions {
  double step = 0.0;
  double hard_braking = 0.0;
  FaultOptions fault;
};

/// config/planners.yaml, section external.
struct ExternalOptions {
  double interval = 0.0;
  double timeout = 0.0;
};

}  // namespace forge
