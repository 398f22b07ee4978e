#include "collision_forge/study/commands/study_commands.h"

namespace forge {

void addStudyCommands(CommandLine& line) {
  line.addGroup(kOther, "study",
                "Research commands: measure, make data sets, train; see forge study "
                "--help.");
  addEvaluate(line);
  addMeasureLatency(line);
  addMeasureLidar(line);
  addMeasurePatterns(line);
  addTestOnClips(line);
  addTuneOnClips(line);
  addDataset(line);
  addTrain(line);
  addSpeedsFit(line);
}

}  // namespace forge
