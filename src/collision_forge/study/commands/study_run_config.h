#pragma once

#include <string>

#include "collision_forge/study/settings/study_config.h"

namespace forge {

/// As loadRunConfig(), for a command that needs the study's numbers, too.
StudyConfig loadStudyRunConfig(const std::string& directory);

}  // namespace forge
