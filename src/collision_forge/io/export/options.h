#pragma once

#include <map>
#include <string>

#include "collision_forge/base/map/geo_point.h"
#include "collision_forge/base/map/lane_map.h"

namespace forge {

class Section;

/// Content of exported crashes (config/export.yaml).
struct ExportOptions {
  double step = 0.1;     ///< s between states: the sampling of attacks
  double history = 0.0;  ///< s before t0, if recorded
  double tail = 1.0;     ///< s after contact: shows the crash, little of the simulated motion
  double radius = 0.0;   ///< m around the paths of ego and attacker: lanes and other agents
  double lane_width = kLaneWidth;           ///< m, of lanes without an outline
  std::map<std::string, GeoPoint> origins;  ///< by map location; default 0, 0
};

/// Reads the struct from its section. Throws ConfigError for a missing key or a value out of range.
void readOptions(Section& section, ExportOptions& options);

}  // namespace forge
