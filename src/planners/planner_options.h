#pragma once

#include "planners/kinematic_bicycle.h"
#include "planners/lqr_tracker.h"

namespace forge {

/// config/planners.yaml, a member a section.
struct PlannerOptions {
  KinematicBicycleOptions bicycle;
  LqrOptions lqr;
};

}  // namespace forge
