#include "collision_forge/study/commands/study_commands.h"

#include "collision_forge/app/report.h"
#include "collision_forge/study/evaluation/report_rows.h"

namespace forge {

void addStudyCommands(CommandLine& line) {
  line.addGroup(kOther, "study",
                "Research commands: measure, make data sets, train; see forge study "
                "--help.");
  addEvaluate(line);
  addMeasureLatency(line);
  addMeasurePatterns(line);
  addTestOnClips(line);
  addTuneOnClips(line);
  addReportCommand(
      line, kMeasuring, "study report",
      "results.csv of forge study evaluate, attempts.jsonl of forge study dataset, and all files "
      "that forge report accepts",
      evaluationFormats());
  addDataset(line);
  addTrain(line);
  addSpeedsFit(line);
}

}  // namespace forge
