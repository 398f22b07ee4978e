#include "collision_forge/app/run_config.h"

#include "collision_forge/io/batch/options.h"
#include "collision_forge/io/batch/ranks.h"

namespace forge {

Config loadRunConfig(const std::string& directory) {
  Ranks::watch(loadRankOptions(directory));
  return loadConfig(directory);
}

}  // namespace forge
