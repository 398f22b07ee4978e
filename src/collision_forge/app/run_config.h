#pragma once

#include "collision_forge/planner_test/settings/config.h"

namespace forge {

/// The configuration in `folder`, for a command whose work is dealt out: from now on ranks that
/// are silent end the run, as ranks.yaml there says. To be called before anything asks for the
/// ranks. Throws ConfigError.
Config loadRunConfig(const ConfigFolder& folder);

}  // namespace forge
