#pragma once

#include <map>
#include <string>

#include "collision_forge/attack/forecast/options.h"
#include "collision_forge/study/dataset/options.h"
#include "collision_forge/study/generators/options.h"
#include "collision_forge/study/training/options.h"

namespace forge {

/// The numbers of the product and of its study: all files of config/.
struct StudyConfig : LearningOptions {
  SpeedModelFitOptions speed_model_fit;
  DatasetOptions dataset;
  GeneratorOptions generators;
  GeneratorOptions published_network;  ///< of network_published.yaml
};

/// loadConfig() and the files of config/study/. Throws ConfigError for a missing, unknown or
/// malformed key.
StudyConfig loadStudyConfig(const ConfigFolder& folder);

/// The fingerprints of the study's files that its results depend on; those of training are
/// described by the run itself.
std::map<std::string, std::string> studyFingerprints(const ConfigFolder& folder);

}  // namespace forge
