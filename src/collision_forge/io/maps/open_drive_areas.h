#pragma once

#include <optional>
#include <string>
#include <vector>

#include "collision_forge/base/map/lane_map.h"
#include "collision_forge/io/maps/open_drive_strips.h"

namespace forge {

/// Use of the area of a lane of OpenDRIVE in the map.
enum class LaneUse {
  kNothing,  ///< no surface for traffic, such as a median
  kLane,     ///< a lane, and drivable area
  kRoad,     ///< drivable area only, such as parking
  kWalkway,  ///< walkway, such as a sidewalk
};

/// Returns the use of a lane type of ASAM OpenDRIVE 1.4 to 1.8; nullopt for an unknown type.
std::optional<LaneUse> laneUse(const std::string& type);

/// Appends the drivable area and the walkways of a section, m in the map frame, to `map`.
/// Neighbours of the same use become one polygon; kLane counts as kRoad, an unknown type as
/// kNothing. `strips` must be the result of laneStrips() for `section`.
void addAreas(const OpenDriveSection& section, const SectionStrips& strips, LaneMap& map);

/// Returns the gaps of up to 20 m^2 that the areas (m) of a junction's roads enclose, such as its
/// middle. Larger gaps may be islands; holes of `areas` are ignored. Returns none if the union of
/// the areas cannot be computed.
std::vector<Polygon> gapsBetween(const std::vector<Polygon>& areas);

}  // namespace forge
