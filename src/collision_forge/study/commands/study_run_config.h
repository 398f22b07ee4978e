#pragma once

#include <string>

#include "collision_forge/app/options.h"
#include "collision_forge/study/settings/study_config.h"

namespace forge {

/// Returns the inputs of a run on which its results depend, as a resumable run records them:
/// inputsOf() plus studyFingerprints() and the fingerprints of the weights of all learned
/// baselines.
ResumableFile::Options studyInputsOf(const StudyConfig& config, const LogSource& logs);

}  // namespace forge
