#include "collision_forge/study/commands/study_run_config.h"

#include "collision_forge/io/batch/options.h"
#include "collision_forge/io/batch/ranks.h"

namespace forge {

StudyConfig loadStudyRunConfig(const std::string& directory) {
  Ranks::watch(loadRankOptions(directory));
  return loadStudyConfig(directory);
}

}  // namespace forge
