#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "collision_forge/attack/forecast/options.h"
#include "collision_forge/base/config/config_folder.h"
#include "collision_forge/base/map/geo_point.h"
#include "collision_forge/base/map/lane_map.h"
#include "collision_forge/base/scene/input_limits.h"
#include "collision_forge/base/scene/scene.h"

namespace forge {

class Section;

/// How recordings and maps are read and converted to bags (config/conversion.yaml).
struct ConversionOptions {
  double map_radius = 0.0;             ///< m around the ego's path that a converted map covers
  double centerline_resolution = 0.0;  ///< m between the poses of a centreline built from arcs
};

/// Content of a bag with an injected attack (config/attacked_bag.yaml).
struct AttackedBagOptions {
  double frame_rate = 0.0;           ///< Hz, minimum rate of agents after t0
  double seconds_after_stand = 0.0;  ///< s from standstill of both vehicles to the end of the bag
  double end_time = 0.0;             ///< s from contact to the end with --after-contact end
};

/// How recordings and maps are read.
struct DataOptions {
  EgoVehicle ego_vehicle;  ///< config/ego_vehicle.yaml
  ConversionOptions conversion;
  InputLimits input_limits;                      ///< config/input_limits.yaml
  std::map<std::string, DrivingSide> locations;  ///< config/locations.yaml, by prefix of the name
  std::map<std::string, GeoPoint> origins;       ///< ExportOptions::origins
  std::map<std::string, AgentClass> categories;  ///< config/categories.yaml
};

/// Files fitted to recordings (config/models.yaml); paths are "" if not set. methods.yaml adds
/// `method_libraries`.
struct ModelOptions {
  bool non_commercial_weights = true;  ///< false: ignore isNonCommercial() weights
  std::string pattern_network;
  std::string speed_model;
  std::vector<std::string> method_libraries;  ///< shared libraries, see methodsWith()
  ConfigFolder folder;                        ///< source of generatorWeights()
};

/// The key that switches non-commercial weights off, for messages.
inline constexpr char kNonCommercialKey[] = "models.non_commercial_weights in models.yaml";

/// Returns true if `non_commercial.txt` in the file's folder lists the file: its licence allows
/// non-commercial use only.
bool isNonCommercial(const std::string& file);

/// Returns `file`, or "" if `options` exclude its licence.
std::string allowedWeights(const ModelOptions& options, const std::string& file);

/// Returns the weight files of the learned baselines by model name: first the weights trained on
/// all scenes, then the weights trained without some of them. A model's list is empty if it has no
/// files or their licence is excluded. Reads study/generator_weights.yaml. Throws ConfigError.
std::map<std::string, std::vector<std::string>> generatorWeights(const ModelOptions& options);

/// How clips of COLLIDE (arXiv 2510.12206) become scenes.
struct CollideOptions {
  BoxSize box{4.7, 2.0};  ///< m; size of every vehicle, as in the paper: the files have no sizes
  double tail = 2.0;      ///< s of constant velocity appended after a clip's last frame
  double held_out_share = 0.1;  ///< share 0..1 of scenes for validation
};

// Read the struct from its section. Throw ConfigError for a missing key or a value out of range.
void readOptions(Section& section, ConversionOptions& options);
void readOptions(Section& section, AttackedBagOptions& options);
void readOptions(Section& section, std::map<std::string, DrivingSide>& locations);
void readOptions(Section& section, std::map<std::string, AgentClass>& categories);
void readOptions(Section& section, ModelOptions& options);

/// Returns the driving side of a location by its longest matching prefix; nullopt if none matches.
std::optional<DrivingSide> configuredSide(const DataOptions& options, const std::string& location);
/// As above; throws ConfigError if no prefix matches.
DrivingSide drivingSide(const DataOptions& options, const std::string& location);

}  // namespace forge
