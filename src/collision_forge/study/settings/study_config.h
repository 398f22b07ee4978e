#pragma once

#include <map>
#include <string>

#include "collision_forge/attack/forecast/options.h"
#include "collision_forge/study/dataset/options.h"
#include "collision_forge/study/generators/options.h"
#include "collision_forge/study/training/options.h"

namespace forge {

/// The complete configuration: all files of config/ and config/study/.
struct StudyConfig : LearningOptions {
  SpeedModelFitOptions speed_model_fit;
  DatasetOptions dataset;
  GeneratorOptions generators;
  GeneratorOptions published_network;  ///< from network_published.yaml
};

/// Reads the files of loadConfig() and of config/study/. Throws ConfigError for a missing, unknown
/// or malformed key.
StudyConfig loadStudyConfig(const ConfigFolder& folder);

/// Returns the fingerprints of the files of config/study/ that results of evaluations depend on,
/// without the training configurations, which describeRun() records.
std::map<std::string, std::string> studyFingerprints(const ConfigFolder& folder);

}  // namespace forge
