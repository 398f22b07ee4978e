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
  SpeedModelFitOptions speed_model_fit;  ///< from study/speed_model_fit.yaml
  DatasetOptions dataset;                ///< from study/dataset.yaml
  GeneratorOptions generators;           ///< from study/generators.yaml
  GeneratorOptions published_network;    ///< from study/network_published.yaml
};

/// Returns the configuration: reads the files of loadConfig() and of config/study/. Throws
/// ConfigError for a missing, unknown or malformed key.
StudyConfig loadStudyConfig(const ConfigFolder& folder);

/// Returns the fingerprints of the files of config/study/ that results depend on, by name
/// ("config/study/dataset.yaml", at present the only one), without the training configurations,
/// which describeRun() records. Throws ConfigError.
std::map<std::string, std::string> studyFingerprints(const ConfigFolder& folder);

}  // namespace forge
