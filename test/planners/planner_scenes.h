#pragma once

#include "formats/config.h"

namespace forge {

/// What config/ says.
inline const Config& shippedConfig() {
  static const Config config = loadConfig(COLLISION_FORGE_SOURCE_DIR "/config");
  return config;
}

}  // namespace forge
