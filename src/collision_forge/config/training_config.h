#pragma once

#include <string>

#include "collision_forge/config/config.h"

namespace forge {

/// Reads training.yaml in `directory` into the three members of networks to be trained. Throws
/// ConfigError for a missing, unknown or malformed key.
void loadTraining(const std::string& directory, Config& config);

}  // namespace forge
