#pragma once

#include <map>
#include <string>

#include "collision_forge/base/map/lane_map.h"
#include "collision_forge/base/scene/track.h"

namespace forge {

class Section;

/// Degrees north and east.
struct GeoPoint {
  double latitude = 0.0;
  double longitude = 0.0;
};

/// config/export.yaml, where the unit and source of each of its keys stand.
struct ExportOptions {
  double step = 0.1;  ///< s between states: the sampling of attacks
  double history = 0.0;
  double tail = 1.0;  ///< s after the contact: enough to see the crash, short of made-up motion
  double radius = 0.0;
  double lane_width = kLaneWidth;  ///< m
  /// m, of every class: medians of nuScenes' annotations (anchors of mmdetection3d's nuScenes
  /// models). Most emergency vehicles are cars and have no anchor; that of animals is a guess.
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
  std::map<std::string, GeoPoint> origins;  ///< of maps, by location; others are at 0, 0
};

void readOptions(Section& section, ExportOptions& options);

}  // namespace forge
