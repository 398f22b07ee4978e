#include "collision_forge/study/commands/study_run_config.h"

#include "collision_forge/planner_test/settings/config_fingerprint.h"

namespace forge {

ResumableFile::Options studyInputsOf(const StudyConfig& config, const LogSource& logs) {
  ResumableFile::Options options = inputsOf(config, logs);
  options.merge(studyFingerprints(config.folder));
  for (const auto& [model, paths] : generatorWeights(config)) addWeights(model, paths, options);
  return options;
}

}  // namespace forge
