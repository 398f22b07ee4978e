#pragma once

#include "collision_forge/planner_test/settings/config.h"

namespace forge {

/// Loads the configuration of a command that distributes its work over MPI ranks. From this call
/// on, a rank that stays silent longer than ranks.yaml allows ends the run. Must be called before
/// the first use of the ranks. Throws ConfigError.
Config loadRunConfig(const ConfigFolder& folder);

}  // namespace forge
