#pragma once

#include <string>

#include "collision_forge/io/export/crash_record.h"

namespace forge {

/// Returns the origin of the OpenDRIVE and OpenSCENARIO files in the map frame: the ego's first
/// position, rounded to metres. Their readers compute in single precision.
Vector2 localOrigin(const CrashRecord& record);

/// An OpenDRIVE file.
struct OpenDriveFile {
  std::string text;           ///< XML, UTF-8
  std::size_t unbundled = 0;  ///< RoadNetwork::unbundled
};

/// Returns the record's lanes as OpenDRIVE 1.6 (ASAM, 2020), relative to localOrigin(). The roads
/// come from roadNetwork(). The reference line is the centreline of one lane; `laneOffset` and
/// widths, both piecewise linear, put the middles of all lanes on their centrelines. LaneWriter
/// describes types and marks of lanes, ObjectWriter the objects. Left-hand roads have `rule` LHT
/// and the lanes along the reference line on the left. The header has the map's origin as a
/// transverse Mercator projection and localOrigin() as offset. Throws std::invalid_argument for a
/// number that is not finite.
OpenDriveFile openDriveFile(const CrashRecord& record, const ExportOptions& options);

}  // namespace forge
