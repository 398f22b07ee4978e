#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "collision_forge/study/generators/options.h"
#include "collision_forge/study/training/training_data.h"

namespace forge {

/// The data, options and output folder of a training.
struct TrainingRun {
  TrainingSources sources;  ///< logs and clips to train on
  std::string out;          ///< folder of the run
  ConfigFolder config;      ///< folder from which `options` and `generators` were read
  /// Fingerprints of further configuration files that the results depend on, by name of the file.
  std::map<std::string, std::string> config_files;
  LearningOptions options;  ///< all options of the configuration but `generators`
  std::string generator;    ///< name of the learned baseline to train, trafficModelNames(); empty:
                            ///< the collision-pattern network
  GeneratorOptions generators;  ///< only for a learned baseline, from its configuration file
  std::string device = "cpu";   ///< "cpu" or "cuda"
  int fold = 0;                 ///< fold of the scenes to leave out, 1 to `folds`; 0: none
  int folds = 5;                ///< number of folds
  int threads = 1;              ///< CPU threads for training
  int stop_after = 0;  ///< stop after this epoch (from 1, counted over all runs), to be resumed; 0:
                       ///< train all epochs
  std::uint64_t seed = 0;  ///< seed of folds, validation split, samples and training
};

}  // namespace forge
