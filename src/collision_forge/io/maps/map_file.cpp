#include "collision_forge/io/maps/map_file.h"

#include <algorithm>
#include <array>
#include <filesystem>

#include "collision_forge/base/config/config_error.h"
#include "collision_forge/base/scene/input_limits.h"
#include "collision_forge/base/scene/map_limits.h"
#include "collision_forge/io/logs/nuscenes_map.h"
#include "collision_forge/io/maps/common_road_map.h"
#include "collision_forge/io/maps/lanelet2_map.h"
#include "collision_forge/io/maps/map_error.h"
#include "collision_forge/io/maps/open_drive_map.h"
#include "collision_forge/io/maps/xml_input.h"

namespace forge {
namespace {

DrivingSide sideOf(const DataOptions& options, const std::string& location,
                   const std::string& path) {
  try {
    return drivingSide(options, location);
  } catch (const ConfigError& error) {
    throw ConfigError(path + ": " + error.what());
  }
}

LaneMap readMapExpansion(const std::string& path, const DataOptions& options,
                         std::vector<std::string>& warnings) {
  const std::string location = std::filesystem::path(path).stem().string();
  return readNuScenesMapFile(path, sideOf(options, location, path),
                             {options.conversion.centerline_resolution, options.input_limits},
                             &warnings);
}

/// A kind of map file.
struct MapKind {
  const char* name;
  const char* root;  ///< as rootOf() returns it
  /// Reads a file with this root; adds one line per kind of defect to `warnings`.
  LaneMap (*read)(const std::string& path, const DataOptions& options,
                  std::vector<std::string>& warnings);
};

constexpr std::array kMapKinds = {
    MapKind{"nuScenes map expansion", kJsonRoot, readMapExpansion},
    MapKind{"OpenDRIVE", "<OpenDRIVE>", readOpenDriveMap},
    MapKind{"Lanelet2", "<osm>", readLanelet2Map},
    MapKind{"CommonRoad", "<commonRoad>", readCommonRoadMap},
};

std::string describe(const std::string& root) {
  if (root.empty()) return "neither a JSON object nor XML";
  return "an XML file with the root element " + root;
}

const MapKind& kindOf(const std::string& path) {
  const std::string root = rootOf(path);
  const auto* const found = std::find_if(kMapKinds.begin(), kMapKinds.end(),
                                         [&](const MapKind& kind) { return root == kind.root; });
  if (found != kMapKinds.end()) return *found;
  std::string known;
  for (const MapKind& kind : kMapKinds) {
    known += (known.empty() ? "" : ", ") + std::string(kind.name) + " (" + kind.root + ")";
  }
  throw MapError(path + ": is " + describe(root) + "; the maps that can be read are: " + known);
}

}  // namespace

LaneMap readMapFile(const std::string& path, const DataOptions& options,
                    std::vector<std::string>* warnings) {
  const MapKind& kind = kindOf(path);
  std::vector<std::string> defects;
  LaneMap map = kind.read(path, options, defects);
  map.location = std::filesystem::path(path).stem().string();
  if (map.lanes.empty()) {
    std::string complaint = path + ": is a map of the kind " + kind.name + " without lanes";
    for (const std::string& defect : defects) complaint += "; " + defect;
    throw MapError(complaint);
  }
  keepWithin(map, options.input_limits, &defects);
  checkMap(map, options.input_limits, path);
  if (warnings != nullptr) warnings->insert(warnings->end(), defects.begin(), defects.end());
  return map;
}

}  // namespace forge
