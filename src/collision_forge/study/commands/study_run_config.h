#pragma once

#include <string>

#include "collision_forge/app/options.h"
#include "collision_forge/study/settings/study_config.h"

namespace forge {

/// As loadRunConfig(), for a command that needs the study's numbers, too.
StudyConfig loadStudyRunConfig(const ConfigFolder& folder);

/// As inputsOf() of a study: its configuration and the weights of all learned baselines, too.
ResumableFile::Options studyInputsOf(const StudyConfig& config, const LogSource& logs);

}  // namespace forge
