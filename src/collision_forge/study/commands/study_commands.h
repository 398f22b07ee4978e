#pragma once

#include "collision_forge/app/command_line.h"

namespace forge {

// Each function adds one command with its options to `line`, which runs it later; the source file
// of the same name implements it.

/// study dataset: makes a collision data set from logs.
void addDataset(CommandLine& line);
/// study evaluate: measures a method and baselines on COLLIDE clips or on requests over logs.
void addEvaluate(CommandLine& line);
/// study measure latency: measures the latency of the service generate_collision.
void addMeasureLatency(CommandLine& line);
/// study measure lidar: compares recorded vehicles in lidar clouds with inserted bodies.
void addMeasureLidar(CommandLine& line);
/// study measure patterns: compares predicted collision patterns with COLLIDE clips.
void addMeasurePatterns(CommandLine& line);
/// study speeds fit: fits the speed model of drivers to recorded egos.
void addSpeedsFit(CommandLine& line);
/// study test: tests planners on COLLIDE clips.
void addTestOnClips(CommandLine& line);
/// study train: trains the collision-pattern network or a learned baseline.
void addTrain(CommandLine& line);
/// study tune: tunes a planner on COLLIDE clips.
void addTuneOnClips(CommandLine& line);

// The headings of forge study --help, under which the commands stand.
inline const std::string kMeasuring = "Measure and compare";
inline const std::string kTraining = "Data sets and training";

}  // namespace forge
