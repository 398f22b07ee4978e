#include "collision_forge/app/run_config.h"

#include "collision_forge/batch/options.h"
#include "collision_forge/batch/ranks.h"

namespace forge {

Config loadRunConfig(const std::string& directory) {
  Ranks::get().watch(loadRankOptions(directory).max_silence);
  return loadConfig(directory);
}

}  // namespace forge
