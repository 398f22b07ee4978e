#pragma once

#include <cstdint>
#include <set>
#include <string>

#include "collision_forge/drawing/options.h"
#include "collision_forge/planners/options.h"
#include "collision_forge/training/training_data.h"

namespace forge {

/// What a network is trained on, how, and where the run is written.
struct TrainingRun {
  TrainingSources sources;
  std::string out;     ///< folder of the run
  std::string config;  ///< folder with the configuration files, for these two
  LearningOptions options;
  PlannerOptions planners;  ///< of a planner
  DrawingOptions drawing;
  std::string device = "cpu";
  int fold = 0;  ///< part of the scenes that is left out, from 1; 0: none
  int folds = 5;
  int threads = 1;     ///< that train
  int stop_after = 0;  ///< epoch; 0: the last
  std::uint64_t seed = 0;
};

/// The scenes of the part that a run leaves out. Throws std::runtime_error for a part without any.
std::set<std::string> leftOutScenes(const TrainingRun& run);

}  // namespace forge

/// Trains the collision-pattern network; under mpirun over all ranks; goes on where a run of the
/// same stopped. Writes weights, metrics,
/// curves and its state to run.out, and throws std::runtime_error for what is wrong. Found by this
/// name in the library, which brings libtorch along and is loaded when it is needed alone.
extern "C" void forgeTrainPatternNetwork(const forge::TrainingRun& run);

/// Trains the small planner of the suite on logs, and writes planner.pt, its losses and its errors
/// on scenes that it was trained on and on those left out to run.out. Begins anew every time: it
/// takes a minute. Throws std::runtime_error for what is wrong.
extern "C" void forgeTrainPlanner(const forge::TrainingRun& run);
