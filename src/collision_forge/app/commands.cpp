#include "collision_forge/app/command_line.h"

namespace forge {

void addCommands(CommandLine& line) {
  addConvert(line);
  addInject(line);
  addPossible(line);
  addRequests(line);
  addGenerate(line);
  addExport(line);
  addEvaluate(line);
  addCompare(line);
  addMeasureControls(line);
  addMeasureCoverage(line);
  addMeasureEgoFutures(line);
  addMeasureLatency(line);
  addMeasureMethods(line);
  addMeasurePatterns(line);
  addMeasureAttackers(line);
  addMeasurePlanners(line);
  addReport(line);
  addTest(line);
  addTune(line);
  addDataset(line);
  addTrain(line);
  addSpeedsCollect(line);
  addSpeedsFit(line);
  addCompletion(line);
}

}  // namespace forge
