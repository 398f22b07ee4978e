#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "collision_forge/planner_test/planners/options.h"
#include "collision_forge/study/generators/options.h"
#include "collision_forge/study/training/training_data.h"

namespace forge {

/// What a network is trained on, how, and where the run is written.
struct TrainingRun {
  TrainingSources sources;
  std::string out;      ///< folder of the run
  ConfigFolder config;  ///< the configuration, for these two
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

}  // namespace forge
