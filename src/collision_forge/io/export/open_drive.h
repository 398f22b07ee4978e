#pragma once

#include <string>

#include "collision_forge/io/export/crash_record.h"

namespace forge {

/// Returns the origin of the OpenDRIVE and OpenSCENARIO files in the map frame: the ego's first
/// position, rounded to metres. Their readers compute in single precision.
Vector2 localOrigin(const CrashRecord& record);

/// Returns the record's lanes as OpenDRIVE 1.6 (ASAM, 2020), relative to localOrigin(). Every lane
/// or connector is a road (RoadNetwork) with one lane of constant width; `laneOffset` puts the
/// lane's centre on the road's reference line. Left-hand roads have `rule` LHT and their lane on
/// the left. The header has the map's origin as a transverse Mercator projection and localOrigin()
/// as offset.
std::string openDriveText(const CrashRecord& record, const ExportOptions& options);

}  // namespace forge
