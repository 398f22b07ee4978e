#pragma once

#include "planners/kinematic_bicycle.h"
#include "planners/lqr_tracker.h"
#include "planners/pdm_options.h"

namespace forge {

/// config/planners.yaml, a member a section.
struct PlannerOptions {
  KinematicBicycleOptions bicycle;
  LqrOptions lqr;
  RouteCenterlineOptions route_centerline;
  PdmOptions pdm;
};

}  // namespace forge
