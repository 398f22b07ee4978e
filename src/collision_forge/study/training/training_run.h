#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "collision_forge/study/generators/options.h"
#include "collision_forge/study/training/training_data.h"

namespace forge {

/// The data, options and output folder of a training.
struct TrainingRun {
  TrainingSources sources;
  std::string out;      ///< folder of the run
  ConfigFolder config;  ///< source of `options` and `generators`
  /// Fingerprints of further configuration files that the results depend on, by name.
  std::map<std::string, std::string> config_files;
  LearningOptions options;
  std::string generator;        ///< name of the learned baseline to train; empty: none
  GeneratorOptions generators;  ///< only for a learned baseline, from its configuration file
  std::string device = "cpu";   ///< "cpu" or "cuda"
  int fold = 0;                 ///< fold of the scenes to leave out, from 1; 0: none
  int folds = 5;                ///< number of folds
  int threads = 1;              ///< CPU threads for training
  int stop_after = 0;           ///< stop after this epoch, to be resumed; 0: the last
  std::uint64_t seed = 0;
};

}  // namespace forge
