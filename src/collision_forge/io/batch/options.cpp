#include "collision_forge/io/batch/options.h"

#include "collision_forge/base/config/config_file.h"
#include "collision_forge/base/config/config_folder.h"

namespace forge {

void readOptions(Section& section, RankOptions& options) {
  options.max_silence = section.atLeast("max_silence", 1.0);
  options.max_meeting = section.atLeast("max_meeting", 1.0);
}

RankOptions loadRankOptions(const ConfigFolder& folder) {
  RankOptions options;
  readConfigFile(folder, "ranks", options);
  return options;
}

}  // namespace forge
