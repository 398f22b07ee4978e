#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>

#include "collision_forge/planner_test/planners/options.h"
#include "collision_forge/study/generators/options.h"
#include "collision_forge/study/training/training_data.h"

namespace forge {

/// What a network is trained on, how, and where the run is written.
struct TrainingRun {
  TrainingSources sources;
  std::string out;     ///< folder of the run
  std::string config;  ///< folder with the configuration files, for these two
  /// Fingerprints of those that results depend on beside the one that is trained by, by name.
  std::map<std::string, std::string> config_files;
  LearningOptions options;
  PlannerOptions planners;      ///< of a planner
  bool is_planner = false;      ///< train a planner, not the network
  std::string generator;        ///< train the generator of this name; empty: none
  GeneratorOptions generators;  ///< of a generator, from the file that its numbers stand in
  std::string device = "cpu";
  int fold = 0;  ///< part of the scenes that is left out, from 1; 0: none
  int folds = 5;
  int threads = 1;     ///< that train
  int stop_after = 0;  ///< epoch; 0: the last
  std::uint64_t seed = 0;
};

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
