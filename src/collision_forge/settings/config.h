#pragma once

#include <string>

#include "collision_forge/answers/options.h"
#include "collision_forge/attack/options.h"
#include "collision_forge/config/config_error.h"
#include "collision_forge/data/options.h"
#include "collision_forge/drawing/options.h"
#include "collision_forge/export/options.h"
#include "collision_forge/network/options.h"
#include "collision_forge/report/options.h"
#include "collision_forge/scene/options.h"
#include "collision_forge/trials/options.h"
#include "collision_forge/verify/options.h"

namespace forge {

/// The numbers of the product, as read from the files of config/. Modules are handed their part.
/// What studies need beside it: StudyConfig.
struct Config : AnswerOptions {
  EncodingOptions encoding;
  LiveOptions live;
  AttackedBagOptions attacked_bag;
  DrawingOptions drawing;
  RequestListOptions requests;
  TrialOptions planners;
  ReportOptions report;
  ExportOptions exports;
};

/// Reads the product's files of config/ in `directory`. Throws ConfigError for a missing, unknown
/// or malformed key.
Config loadConfig(const std::string& directory);

}  // namespace forge
