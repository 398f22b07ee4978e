#pragma once

#include <string>

#include "collision_forge/attack/options.h"
#include "collision_forge/config/config_error.h"
#include "collision_forge/data/options.h"
#include "collision_forge/dataset/options.h"
#include "collision_forge/drawing/options.h"
#include "collision_forge/export/options.h"
#include "collision_forge/generators/options.h"
#include "collision_forge/network/options.h"
#include "collision_forge/report/options.h"
#include "collision_forge/scene/options.h"
#include "collision_forge/study/options.h"
#include "collision_forge/training/options.h"
#include "collision_forge/trials/options.h"
#include "collision_forge/verify/options.h"

namespace forge {

/// Everything that can be tuned, as read from the files of config/. Rooms are handed their part.
struct Config : LearningOptions {
  SpeedModelFitOptions speed_model_fit;
  EncodingOptions encoding;
  LiveOptions live;
  AttackedBagOptions attacked_bag;
  DrawingOptions drawing;
  RequestListOptions requests;
  DatasetOptions dataset;
  TrialOptions planners;
  GeneratorOptions generators;
  GeneratorOptions published_network;  ///< of network_published.yaml
  ReportOptions report;
  ExportOptions exports;
};

/// Reads the files of config/ in `directory`. Throws ConfigError for a missing, unknown or
/// malformed key.
Config loadConfig(const std::string& directory);

}  // namespace forge
