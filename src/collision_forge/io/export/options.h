#pragma once

#include <map>
#include <string>

#include "collision_forge/base/map/geo_point.h"
#include "collision_forge/base/map/lane_map.h"
#include "collision_forge/base/scene/track.h"

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
  /// m, box height by class: medians of nuScenes' annotations (anchors of mmdetection3d's nuScenes
  /// models). Emergency vehicles, mostly cars, have no anchor; animals are an estimate.
  std::map<AgentClass, double> heights = {
      {AgentClass::kCar, 1.73},
      {AgentClass::kTruck, 2.84},
      {AgentClass::kBus, 3.47},
      {AgentClass::kTrailer, 3.87},
      {AgentClass::kConstructionVehicle, 3.19},
      {AgentClass::kEmergencyVehicle, 1.73},
      {AgentClass::kMotorcycle, 1.47},
      {AgentClass::kBicycle, 1.28},
      {AgentClass::kPedestrian, 1.77},
      {AgentClass::kAnimal, 0.5},
      {AgentClass::kStaticObject, 0.98},
  };
  /// Origin of the map frame, by LaneMap::location; 0, 0 for others.
  std::map<std::string, GeoPoint> origins;
};

/// Reads `history`, `radius` and `origins` from the root section of the file. Throws ConfigError
/// for a missing key or a value out of range.
void readOptions(Section& section, ExportOptions& options);

}  // namespace forge
