#include <stdexcept>

#include "collision_forge/app/command_line.h"

namespace forge {

void addStudyCommands(CommandLine& line) {
  line.add(kOther, "study",
           "Not available: this build was configured with COLLISION_FORGE_STUDY=OFF.",
           []() -> int {
             throw std::runtime_error(
                 "this build has no study commands; rebuild it with -DCOLLISION_FORGE_STUDY=ON");
           })
      .allow_extras();
}

}  // namespace forge
