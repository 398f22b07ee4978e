#pragma once

#include <string>

#include "collision_forge/attack/options.h"
#include "collision_forge/planners/planner_options.h"

namespace forge {

/// Reads planners.yaml in `directory`; `limits` are those of the ego. Throws ConfigError for a
/// missing, unknown or malformed key.
PlannerOptions loadPlanners(const std::string& directory, const VehicleLimits& limits);

/// The same of such a file's text; `path` is what errors name.
PlannerOptions parsePlanners(const std::string& path, const std::string& text,
                             const VehicleLimits& limits);

}  // namespace forge
