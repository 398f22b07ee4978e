#pragma once

#include <string>

#include "collision_forge/config/config.h"

namespace forge {

/// Reads what attacks are found and judged by, in `directory`: vehicle_limits.yaml,
/// collision_types.yaml, prediction.yaml, search.yaml, verification.yaml, ego_futures.yaml and
/// speed_model_fit.yaml. Throws ConfigError for a missing, unknown or malformed key.
void loadAttack(const std::string& directory, Config& config);

}  // namespace forge
