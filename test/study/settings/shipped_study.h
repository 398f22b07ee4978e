#pragma once

#include "collision_forge/study/settings/study_config.h"

namespace forge {

/// The configuration of config/, including config/study/.
inline const StudyConfig& shippedStudy() {
  static const StudyConfig config = loadStudyConfig(COLLISION_FORGE_SOURCE_DIR "/config");
  return config;
}

}  // namespace forge
