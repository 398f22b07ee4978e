#pragma once

#include <string>
#include <vector>

#include "collision_forge/base/map/lane_map.h"
#include "collision_forge/base/scene/input_limits.h"
#include "collision_forge/io/logs/nuscenes_json.h"

namespace forge {

/// How a map expansion file is read.
struct NuScenesMapOptions {
  double resolution = 1.0;  ///< m between the poses of a centreline, > 0
  InputLimits limits;       ///< of coordinates, radii and numbers of points and lanes
};

/// Reads DATAROOT/maps/expansion/LOCATION.json (map expansion 1.3 or later): lanes and lane
/// connectors with mutual links, drivable area with holes, and walkways; map frame, metres. A lane
/// counts as part of an intersection if the centroid of its outline or the middle of its centreline
/// is in one.
///
/// Leaves out known defects of the published maps: links to missing tokens, lanes without links,
/// arclines or outlines, unusable arclines and polygons, values beyond the limits, and rows with a
/// missing field or a field of another type. Appends one line per kind to `warnings`, if given,
/// with the number of cases and the first token. Throws NuScenesError for a file that is missing,
/// not JSON or of another version, and for a missing layer; InputError for more lanes or points
/// than the limits allow; std::invalid_argument if `options.resolution` is not positive.
LaneMap readNuScenesMap(const std::string& dataroot, const std::string& location,
                        DrivingSide driving_side, const NuScenesMapOptions& options,
                        std::vector<std::string>* warnings = nullptr);

/// As readNuScenesMap(), from a file LOCATION.json at any path.
LaneMap readNuScenesMapFile(const std::string& path, DrivingSide driving_side,
                            const NuScenesMapOptions& options,
                            std::vector<std::string>* warnings = nullptr);

/// Returns the lanes (by outline or centreline), areas and features, whole, that come within
/// `radius` (m) of any of the points (m, map frame) or contain one; in the order of `map`. Removes
/// links to lanes that are left out. The result keeps the location and driving side of `map`;
/// without points all else is empty.
LaneMap cropped(const LaneMap& map, const std::vector<Vector2>& points, double radius);

}  // namespace forge
