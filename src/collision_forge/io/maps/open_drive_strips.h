#pragma once

#include <vector>

#include "collision_forge/io/maps/open_drive_road.h"

namespace forge {

/// The area of a lane in one lane section. Points follow the reference line, whichever way the lane
/// is driven; frame of the map, m.
struct LaneStrip {
  std::vector<Pose2> centre;  ///< yaw along the lane in the direction of the reference line
  /// Border to the left of the reference line's direction, a point per pose of `centre`.
  std::vector<Vector2> left;
  std::vector<Vector2> right;  ///< border to the right of it, a point per pose of `centre`
  double widest = 0.0;         ///< m, largest width over the section
};

/// The strips of a section's lanes, in the order of the lanes: from the reference line outwards.
struct SectionStrips {
  std::vector<LaneStrip> left;   ///< one per element of OpenDriveSection::left
  std::vector<LaneStrip> right;  ///< one per element of OpenDriveSection::right
};

/// Returns the strips of a section of `road`. All strips have points at the same arc lengths, from
/// the begin to the end of the section (a section shorter than 1 mm: at its begin only), so that
/// neighbours share their border's points: at most `resolution` (m, > 0) apart along the reference
/// line, in bends so close that a chord is within 1 cm. Superelevation is ignored. A negative width
/// counts as 0.
SectionStrips laneStrips(const OpenDriveRoad& road, const OpenDriveSection& section,
                         double resolution);

}  // namespace forge
