#include "collision_forge/app/command_line.h"

namespace forge {

void addCommands(CommandLine& line) {
  addConvert(line);
  addInject(line);
  addPossible(line);
  addRequests(line);
  addAsk(line);
  addGenerate(line);
  addExport(line);
  addTest(line);
  addSweep(line);
  addTune(line);
  addReport(line);
  addCompletion(line);
}

}  // namespace forge
