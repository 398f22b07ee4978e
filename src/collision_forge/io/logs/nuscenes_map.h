#pragma once

#include <string>
#include <vector>

#include "collision_forge/base/map/lane_map.h"
#include "collision_forge/base/scene/input_limits.h"
#include "collision_forge/io/logs/nuscenes_json.h"

namespace forge {

struct NuScenesMapOptions {
  double resolution = 1.0;  ///< metres between the poses of a centreline, > 0
  InputLimits limits;
};

/// Reads DATAROOT/maps/expansion/LOCATION.json, map expansion 1.3 or later: lanes and lane
/// connectors with their links made mutual, and the drivable area with its holes. A lane lies in an
/// intersection when the middle of its outline or of its centreline does.
///
/// Known defects of the published maps (links to tokens that do not exist, lanes without links,
/// arclines or outlines, unusable arclines and polygons, those beyond the limits among them) are
/// left out of the result; `warnings`, if given, gets one line a kind with the number of cases and
/// the first of them.
/// Throws NuScenesError for a file that is missing, no JSON or of another version, a layer that is
/// missing, and a row that lacks a field or holds another type there; InputError for more lanes or
/// points than the limits have.
LaneMap readNuScenesMap(const std::string& dataroot, const std::string& location,
                        DrivingSide driving_side, const NuScenesMapOptions& options,
                        std::vector<std::string>* warnings = nullptr);

/// The same of a file LOCATION.json anywhere.
LaneMap readNuScenesMapFile(const std::string& path, DrivingSide driving_side,
                            const NuScenesMapOptions& options,
                            std::vector<std::string>* warnings = nullptr);

/// The lanes (by outline or centreline) and drivable polygons within `radius` metres of any of the
/// points. Links to lanes that are left out go too.
LaneMap cropped(const LaneMap& map, const std::vector<Vector2>& points, double radius);

}  // namespace forge
