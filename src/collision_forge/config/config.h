#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "collision_forge/attack/options.h"
#include "collision_forge/config/config_error.h"
#include "collision_forge/config/dataset_options.h"
#include "collision_forge/config/evaluation_options.h"
#include "collision_forge/drawing/drawing_options.h"
#include "collision_forge/forecast/speed_forecaster.h"
#include "collision_forge/map/lane_map.h"
#include "collision_forge/network/encoding_options.h"
#include "collision_forge/network/network_options.h"
#include "collision_forge/planners/planner_options.h"
#include "collision_forge/scene/scene.h"

namespace forge {

/// config/conversion.yaml, where each number's unit stands.
struct ConversionOptions {
  double map_radius = 0.0;
  double centerline_resolution = 0.0;
};

/// Everything that can be tuned, as read from the files of config/.
struct Config {
  CrashDefinition crash;  ///< what counts as a crash, unless a request says otherwise
  AttackOptions attack;
  std::string speed_profiles;  ///< path of recorded profiles (speed_profiles_file.h); empty: none
  std::string speed_model;     ///< path of a fitted model (speed_model_file.h); empty: none
  SpeedModelFitOptions speed_model_fit;
  std::vector<std::string> method_libraries;  ///< paths; see methodsWith()
  std::string pattern_network;  ///< path of trained networks (pattern_network_file.h); empty: none
  PatternFeatureOptions pattern_features;  ///< these three of networks to be trained
  PatternNetworkOptions pattern_layers;
  TrainingOptions training;
  EgoVehicle ego_vehicle;
  EncodingOptions encoding;
  ConversionOptions conversion;
  DrawingOptions drawing;
  RequestListOptions requests;
  EvaluationOptions evaluation;
  DatasetOptions dataset;
  PlannerOptions planners;
  std::map<std::string, DrivingSide> locations;  ///< by prefix of the location's name
};

/// Reads the files of config/ in `directory`. Throws ConfigError for a missing, unknown or
/// malformed key.
Config loadConfig(const std::string& directory);

/// The recorded profiles that the configuration names, else the model that it names; null when it
/// names neither. Throws SpeedProfilesFileError and SpeedModelFileError.
std::shared_ptr<const SpeedForecaster> loadSpeedForecaster(const Config& config);

/// The side for a location; throws ConfigError when no prefix in config/locations.yaml fits.
DrivingSide drivingSide(const Config& config, const std::string& location);

}  // namespace forge
