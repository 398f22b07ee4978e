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
  double frame_rate = 0.0;           ///< Hz, minimum rate of agents' frames after t0, 10 to 100
  double seconds_after_stand = 0.0;  ///< s from standstill of both vehicles to the end of the bag
  double end_time = 0.0;             ///< s from contact to the end with --after-contact end
};

/// How recordings and maps are read.
struct DataOptions {
  EgoVehicle ego_vehicle;  ///< box and offset of its centre from base_link; config/ego_vehicle.yaml
  ConversionOptions conversion;  ///< config/conversion.yaml
  InputLimits input_limits;      ///< config/input_limits.yaml
  /// Side by prefix of LaneMap::location; config/locations.yaml.
  std::map<std::string, DrivingSide> locations;
  std::map<std::string, GeoPoint> origins;  ///< as ExportOptions::origins
  /// Class by category that nuScenes does not have, in lower case; config/categories.yaml.
  std::map<std::string, AgentClass> categories;
};

/// Files fitted to recordings (config/models.yaml); paths are "" if not set. methods.yaml sets
/// `method_libraries`.
struct ModelOptions {
  /// False: weight files for which isNonCommercial() holds are ignored.
  bool non_commercial_weights = true;
  std::string pattern_network;                ///< path, read by loadPatternNetwork()
  std::string speed_model;                    ///< path, read by readSpeedModel()
  std::vector<std::string> method_libraries;  ///< paths of shared libraries, see methodsWith()
  ConfigFolder folder;                        ///< configuration in which generatorWeights() looks
};

/// The key that switches non-commercial weights off, for messages.
inline constexpr char kNonCommercialKey[] = "models.non_commercial_weights in models.yaml";

/// Returns true if `non_commercial.txt` in the file's folder lists the file by its name, one a
/// line: its licence allows non-commercial use only. Returns false without such a list.
bool isNonCommercial(const std::string& file);

/// Returns the path `file`, or "" if `options` exclude its licence.
std::string allowedWeights(const ModelOptions& options, const std::string& file);

/// Returns the weight files of the learned baselines by model name: first the weights trained on
/// all scenes, then the weights trained without some of them. A model's list is empty if it has no
/// files or if the licence of any of its files is excluded. Reads study/generator_weights.yaml.
/// Throws ConfigError.
std::map<std::string, std::vector<std::string>> generatorWeights(const ModelOptions& options);

/// How clips of COLLIDE (arXiv 2510.12206) become scenes. No file sets these values.
struct CollideOptions {
  BoxSize box{4.7, 2.0};  ///< m; size of every vehicle, as in the paper: the files have no sizes
  double tail = 2.0;      ///< s of constant velocity appended after a clip's last frame
  double held_out_share = 0.1;  ///< share 0..1 of scenes for validation (isHeldOutScene())
};

// Read the struct from its section; a map takes every key of the section. Throw ConfigError for a
// missing key or a value out of range.
void readOptions(Section& section, ConversionOptions& options);
void readOptions(Section& section, AttackedBagOptions& options);
void readOptions(Section& section, std::map<std::string, DrivingSide>& locations);
void readOptions(Section& section, std::map<std::string, AgentClass>& categories);
void readOptions(Section& section, ModelOptions& options);

/// Returns the driving side of a location (LaneMap::location) by the longest prefix of it in
/// `options.locations`; nullopt if none matches.
std::optional<DrivingSide> configuredSide(const DataOptions& options, const std::string& location);
/// As above; throws ConfigError if no prefix matches.
DrivingSide drivingSide(const DataOptions& options, const std::string& location);

}  // namespace forge
