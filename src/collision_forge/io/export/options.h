#pragma once

#include <map>
#include <string>

#include "collision_forge/base/scene/track.h"

namespace forge {

class Section;

/// Degrees north and east.
struct GeoPoint {
  double latitude = 0.0;
  double longitude = 0.0;
};

/// config/export.yaml, where each number's unit and source stand.
struct ExportOptions {
  double step = 0.0;
  double history = 0.0;
  double tail = 0.0;
  double radius = 0.0;
  double lane_width = 0.0;
  std::map<AgentClass, double> heights;     ///< of every class
  std::map<std::string, GeoPoint> origins;  ///< of maps, by location; others are at 0, 0
};

void readOptions(Section& section, ExportOptions& options);

}  // namespace forge
