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
#include "collision_forge/io/lidar/options.h"
#include "collision_forge/io/logs/options.h"
#include "collision_forge/planner_test/report/options.h"
#include "collision_forge/planner_test/trials/options.h"

namespace forge {

/// The configuration in config/, without config/study/, whose options StudyConfig adds. Each module
/// gets its part.
struct Config : AnswerOptions {
  EncodingOptions encoding;         ///< encoding.yaml
  LidarOptions lidar;               ///< lidar.yaml
  LiveOptions live;                 ///< live.yaml
  AttackedBagOptions attacked_bag;  ///< attacked_bag.yaml
  DrawingOptions drawing;           ///< drawing.yaml
  RequestListOptions requests;      ///< requests.yaml
  TrialOptions planners;            ///< planners.yaml, with the ego's limits of vehicle_limits.yaml
  ReportOptions report;             ///< report.yaml
  ExportOptions exports;            ///< export.yaml
};

/// Reads the product's files in config/. If the key non_commercial_weights is false, the paths of
/// weights with a non-commercial licence are empty (`pattern_network`, `speed_model`,
/// `planners.torchscript.file`). Throws ConfigError for a missing, unknown, malformed or
/// out-of-range value, and for an unknown file in an overlay.
Config loadConfig(const ConfigFolder& folder);

/// Returns a sentence for users: whether weights with a non-commercial licence (CC BY-NC-SA 4.0)
/// are in use, their file names, and the key that disables them.
std::string describeWeights(const Config& config);

}  // namespace forge
