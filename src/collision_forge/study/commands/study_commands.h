#pragma once

#include "collision_forge/app/command_line.h"

namespace forge {

// Each function adds one command `study ...`; the source file of the same name implements it.
void addDataset(CommandLine& line);
void addEvaluate(CommandLine& line);
void addMeasureLatency(CommandLine& line);
void addMeasureLidar(CommandLine& line);
void addMeasurePatterns(CommandLine& line);
void addSpeedsFit(CommandLine& line);
void addTestOnClips(CommandLine& line);
void addTrain(CommandLine& line);
void addTuneOnClips(CommandLine& line);

// The section headings of forge study --help.
inline const std::string kMeasuring = "Measure and compare";
inline const std::string kTraining = "Data sets and training";

}  // namespace forge
