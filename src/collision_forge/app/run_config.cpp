#include "collision_forge/app/run_config.h"

#include "collision_forge/batch/options.h"
#include "collision_forge/batch/ranks.h"

namespace forge {

Config loadRunConfig(const std::string& directory) {
  Ranks::watch(loadRankOptions(directory));
  return loadConfig(directory);
}

StudyConfig loadStudyRunConfig(const std::string& directory) {
  Ranks::watch(loadRankOptions(directory));
  return loadStudyConfig(directory);
}

}  // namespace forge
