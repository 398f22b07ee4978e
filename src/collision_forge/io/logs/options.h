#pragma once

#include <map>
#include <string>
#include <vector>

#include "collision_forge/attack/forecast/options.h"
#include "collision_forge/base/config/config_folder.h"
#include "collision_forge/base/map/lane_map.h"
#include "collision_forge/base/scene/input_limits.h"
#include "collision_forge/base/scene/scene.h"

namespace forge {

class Section;

/// config/conversion.yaml, where each number's unit stands.
struct ConversionOptions {
  double map_radius = 0.0;
  double centerline_resolution = 0.0;
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
  bool non_commercial_weights = true;  ///< false: no weights for which isNonCommercial() is true
  std::string pattern_network;
  std::string speed_model;
  std::vector<std::string> method_libraries;  ///< see methodsWith()
  ConfigFolder folder;                        ///< the weights of baselines are read from it at need
};

/// The key that switches non-commercial weights off, for messages.
inline constexpr char kNonCommercialKey[] = "models.non_commercial_weights in models.yaml";

/// True for a file that `non_commercial.txt` in its folder names: its licence allows non-commercial
/// use only.
bool isNonCommercial(const std::string& file);

/// Returns `file`, or "" if `options` do not allow its licence.
std::string allowedWeights(const ModelOptions& options, const std::string& file);

/// The files of the learned baselines, by the names of the models: the weights of all scenes, then
/// those that left some out; no files where there are none, or where their licence is not allowed.
/// Reads study/generator_weights.yaml. Throws ConfigError.
std::map<std::string, std::vector<std::string>> generatorWeights(const ModelOptions& options);

/// How clips of COLLIDE (arXiv 2510.12206) become scenes.
struct CollideOptions {
  BoxSize box{4.7, 2.0};  ///< m; of every vehicle, as the paper measures: the files hold no sizes
  double tail = 2.0;      ///< s that everybody goes straight on after a clip's last frame
  double held_out_share = 0.1;  ///< of the scenes; validation share of the split by scene
};

void readOptions(Section& section, ConversionOptions& options);
void readOptions(Section& section, AttackedBagOptions& options);
void readOptions(Section& section, std::map<std::string, DrivingSide>& locations);
void readOptions(Section& section, ModelOptions& options);

/// The side for a location; throws ConfigError when no prefix fits.
DrivingSide drivingSide(const DataOptions& options, const std::string& location);

}  // namespace forge
