#pragma once

#include "collision_forge/attack/network/options.h"
#include "collision_forge/attack/search/options.h"
#include "collision_forge/attack/verify/options.h"
#include "collision_forge/base/config/config_error.h"
#include "collision_forge/base/config/config_folder.h"
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

/// Reads the product's files of config/. If `non_commercial_weights` is false, the paths of weights
/// that are for non-commercial use are empty. Throws ConfigError for a missing, unknown or
/// malformed key, and for an unknown file of an overlay.
Config loadConfig(const ConfigFolder& folder);

/// Whether weights for non-commercial use are in use, their names, and the key that switches them
/// off: a sentence for people.
std::string describeWeights(const Config& config);

}  // namespace forge
