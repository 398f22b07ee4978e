#pragma once

#include <string>
#include <vector>

#include "collision_forge/base/map/lane_map.h"
#include "collision_forge/io/logs/options.h"

namespace forge {

/// Reads the lanes of an OpenDRIVE file (ASAM OpenDRIVE 1.4 to 1.8). Coordinates are the file's,
/// moved by the header's <offset> as the standard defines it. Elevation, superelevation, objects
/// and signals are ignored.
///
/// Lanes for traffic become lanes of the map, in driving direction, one for each direction of a
/// lane that has both. Sections of a road are joined where a lane continues unchanged, up to 500 m.
/// Lanes shorter than 0.1 m are left out, and the lanes before and after them are linked. The
/// drivable area also contains shoulders, parking, bicycle lanes and alike; sidewalks are walkways.
/// Lanes of connecting roads are connectors; they are intersections if any road of their junction
/// turns by more than 30 degrees. A lane has the id ROAD.SECTION.LANE (SECTION counts from 0), with
/// the suffix ".back" for the second direction of a lane that has both. The driving side is the
/// side of most roads; the location is not set.
///
/// Leaves out roads that cannot be used, links to missing lanes, and lanes of unknown type, and
/// appends one line per kind to `warnings`, with the number of cases and the first. Throws MapError
/// for a file that cannot be read or is not OpenDRIVE 1.x, InputError for more points than the
/// limits allow.
LaneMap readOpenDriveMap(const std::string& path, const DataOptions& options,
                         std::vector<std::string>& warnings);

}  // namespace forge
