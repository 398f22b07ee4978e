#pragma once

#include "planners/kinematic_bicycle.h"

namespace forge {

/// config/planners.yaml, a member a section.
struct PlannerOptions {
  KinematicBicycleOptions bicycle;
};

}  // namespace forge
