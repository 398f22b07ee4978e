#pragma once

#include <string>

#include "collision_forge/attack/network/options.h"
#include "collision_forge/attack/search/options.h"
#include "collision_forge/attack/verify/options.h"
#include "collision_forge/base/config/config_error.h"
#include "collision_forge/base/scene/options.h"
#include "collision_forge/io/answers/options.h"
#include "collision_forge/io/drawing/options.h"
#include "collision_forge/io/export/options.h"
#include "collision_forge/io/logs/options.h"
#include "collision_forge/planner_test/report/options.h"
#include "collision_forge/planner_test/trials/options.h"

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
