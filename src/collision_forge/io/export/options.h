#pragma once

#include <map>
#include <string>

#include "collision_forge/base/map/geo_point.h"
#include "collision_forge/base/map/lane_map.h"

namespace forge {

class Section;

/// Content of exported crashes (config/export.yaml). The file sets `history`, `radius` and
/// `origins`; the other values are fixed.
struct ExportOptions {
  double step = 0.1;     ///< s between states: the sampling of attacks
  double history = 0.0;  ///< s that the record begins before t0, if recorded
  /// s after contact: shows the crash, little of the simulated motion; not in the file.
  double tail = 1.0;
  /// m around the paths of ego and attacker within which lanes and other agents are exported.
  double radius = 0.0;
  double lane_width = kLaneWidth;  ///< m, of lanes without an outline
  /// Origin of the map frame, by LaneMap::location; 0, 0 for others.
  std::map<std::string, GeoPoint> origins;
};

/// Reads `history`, `radius` and `origins` from the root section of the file. Throws ConfigError
/// for a missing key or a value out of range.
void readOptions(Section& section, ExportOptions& options);

}  // namespace forge
