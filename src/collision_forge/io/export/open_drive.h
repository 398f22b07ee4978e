#pragma once

#include <string>

#include "collision_forge/io/export/crash_record.h"

namespace forge {

/// Where the files of ASAM formats have their origin, in the map's frame: the ego's place at the
/// record's beginning to whole metres. Readers compute with single precision.
Vector2 localOrigin(const CrashRecord& record);

/// The record's lanes as OpenDRIVE 1.6 (ASAM, 2020), about localOrigin(). Every lane or connector
/// is a road of its own (RoadNetwork) with one lane of a constant width; its middle is the road's
/// course, by `laneOffset`. Left-hand roads have `rule` LHT and their lane on the left. The header
/// has the map's origin as a transverse Mercator projection, and the local origin as its offset.
std::string openDriveText(const CrashRecord& record, const ExportOptions& options);

}  // namespace forge
