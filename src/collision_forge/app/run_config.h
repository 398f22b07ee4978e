#pragma once

#include <string>

#include "collision_forge/settings/config.h"
#include "collision_forge/study_settings/study_config.h"

namespace forge {

/// The configuration in `directory`, for a command whose work is dealt out: from now on ranks that
/// are silent end the run, as ranks.yaml there says. To be called before anything asks for the
/// ranks. Throws ConfigError.
Config loadRunConfig(const std::string& directory);

/// The same for a command that needs the study's numbers, too.
StudyConfig loadStudyRunConfig(const std::string& directory);

}  // namespace forge
