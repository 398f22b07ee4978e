#pragma once

#include "collision_forge/planner_test/settings/config.h"

namespace forge {

/// Returns the limits of config/input_limits.yaml.
inline const InputLimits& shippedLimits() {
  static const InputLimits limits = loadConfig(COLLISION_FORGE_SOURCE_DIR "/config").input_limits;
  return limits;
}

}  // namespace forge
