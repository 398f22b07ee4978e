#pragma once

#include <string>

#include "collision_forge/app/options.h"
#include "collision_forge/study/settings/study_config.h"

namespace forge {

/// Returns inputsOf() plus the fingerprints of config/study/ and of the weights of all learned
/// baselines.
ResumableFile::Options studyInputsOf(const StudyConfig& config, const LogSource& logs);

}  // namespace forge
