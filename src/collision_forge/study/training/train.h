#pragma once

#include <set>
#include <string>

#include "collision_forge/study/training/training_run.h"

namespace forge {

/// The scenes of the part that a run leaves out. Throws std::runtime_error for a part without any.
std::set<std::string> leftOutScenes(const TrainingRun& run);

/// The collision-pattern network, on logs and clips; under mpirun over all ranks. Goes on where a
/// run of the same stopped. Writes weights of the best epoch, metrics, curves and its state.
void trainPatternNetwork(const TrainingRun& run);

/// The small planner of the suite, on logs. Writes planner.pt, its losses and its errors on scenes
/// that it was trained on and on those left out. Begins anew every time: it takes a minute.
void trainPlanner(const TrainingRun& run);

/// A generator, on clips. Goes on where a run of the same stopped. Writes weights.pt of the best
/// epoch, metrics, curves and its state.
void trainGenerator(const TrainingRun& run);

}  // namespace forge

/// Trains what the run names and writes it to run.out. Found by this name in the library, which
/// brings libtorch along and is loaded when it is needed alone. Throws std::runtime_error for what
/// is wrong.
extern "C" void forgeTrain(const forge::TrainingRun& run);
