#pragma once

#include "collision_forge/study/training/training_run.h"

namespace forge {

/// Trains the collision-pattern network on logs and clips; resumes an interrupted
/// run. Writes weights.bin of the best epoch, metrics and the training state.
/// Throws std::runtime_error.
void trainPatternNetwork(const TrainingRun& run);

/// Trains the learned baseline run.generator on clips; resumes an interrupted run. Writes
/// weights.pt of the best epoch, metrics and the training state. Throws std::runtime_error.
void trainGenerator(const TrainingRun& run);

}  // namespace forge

/// Runs one of the trainings above. The entry point of libcollision_forge_training.so, which links
/// libtorch and is loaded with dlopen() only when needed. Throws std::runtime_error.
extern "C" void forgeTrain(const forge::TrainingRun& run);
