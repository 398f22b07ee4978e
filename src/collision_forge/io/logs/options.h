#pragma once

#include <map>
#include <string>
#include <vector>

#include "collision_forge/attack/forecast/options.h"
#include "collision_forge/base/map/lane_map.h"
#include "collision_forge/base/scene/input_limits.h"
#include "collision_forge/base/scene/scene.h"

namespace forge {

class Section;

/// config/conversion.yaml, where each number's unit stands.
struct ConversionOptions {
  double map_radius = 0.0;
  double centerline_resolution = 0.0;
  double lane_width = 0.0;
};

/// config/attacked_bag.yaml, where each number's unit stands.
struct AttackedBagOptions {
  double frame_rate = 0.0;
  double seconds_after_stand = 0.0;
  double end_time = 0.0;
};

/// How recordings and maps are read.
struct DataOptions {
  EgoVehicle ego_vehicle;  ///< config/ego_vehicle.yaml
  ConversionOptions conversion;
  InputLimits input_limits;                      ///< config/input_limits.yaml
  std::map<std::string, DrivingSide> locations;  ///< config/locations.yaml, by a name's prefix
};

/// config/models.yaml: what was fitted to recordings; paths are empty where there is none. What
/// methods.yaml loads comes with it.
struct ModelOptions {
  std::string pattern_network;
  std::string speed_model;
  /// By the names of the models: the file of all scenes, then those that left some out.
  std::map<std::string, std::vector<std::string>> generator_weights;
  std::vector<std::string> method_libraries;  ///< see methodsWith()
};

/// config/evaluation.yaml, section collide, where each number's unit and source stand.
struct CollideOptions {
  BoxSize box;
  double tail = 0.0;
  double held_out_share = 0.0;
};

void readOptions(Section& section, ConversionOptions& options);
void readOptions(Section& section, AttackedBagOptions& options);
void readOptions(Section& section, std::map<std::string, DrivingSide>& locations);
void readOptions(Section& section, ModelOptions& options);
void readOptions(Section& section, CollideOptions& options);

/// The side for a location; throws ConfigError when no prefix fits.
DrivingSide drivingSide(const DataOptions& options, const std::string& location);

}  // namespace forge
