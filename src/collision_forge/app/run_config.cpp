#include "collision_forge/app/run_config.h"

#include "collision_forge/io/batch/options.h"
#include "collision_forge/io/batch/ranks.h"

namespace forge {

Config loadRunConfig(const ConfigFolder& folder) {
  Ranks::watch(loadRankOptions(folder));
  return loadConfig(folder);
}

}  // namespace forge
