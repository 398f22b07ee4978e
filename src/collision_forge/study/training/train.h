#pragma once

#include "collision_forge/study/training/training_run.h"

namespace forge {

/// Trains the collision-pattern network on logs and clips; resumes an interrupted run. Writes
/// weights.bin of the best epoch (the lowest validation total; without validation scenes the last
/// epoch), metrics.csv and the training state to run.out, and prints the progress. Columns of
/// metrics.csv: epoch, the fields of TrainingLosses, and the same with the prefix validation_
/// (repeats the training losses without validation scenes). Throws std::runtime_error, also without
/// samples and if run.out holds a run with other inputs (openRunFolder()).
void trainPatternNetwork(const TrainingRun& run);

/// Trains the learned baseline run.generator on clips; resumes an interrupted run. Writes
/// weights.pt of the best epoch (the last of TrafficModel::errorNames() is lowest on the validation
/// scenes, without these on the training scenes), metrics.csv and the training state to run.out,
/// and prints the progress. Columns of metrics.csv: epoch, TrafficModel::lossNames() and, with the
/// prefix validation_, errorNames(). Throws std::runtime_error, also without clips and if run.out
/// holds a run with other inputs (openRunFolder()).
void trainGenerator(const TrainingRun& run);

}  // namespace forge

/// Runs trainGenerator() if run.generator is set, else trainPatternNetwork(). The entry point of
/// libcollision_forge_training.so, which links libtorch and is loaded with dlopen() only when
/// needed. Throws std::runtime_error.
extern "C" void forgeTrain(const forge::TrainingRun& run);
