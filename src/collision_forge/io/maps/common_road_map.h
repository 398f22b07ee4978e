#pragma once

#include <string>
#include <vector>

#include "collision_forge/base/map/lane_map.h"
#include "collision_forge/io/logs/options.h"
#include "collision_forge/io/maps/common_road_file.h"

namespace forge {

/// Returns the lanes of a CommonRoad file as a map with the location `location`; adds defects to
/// `warnings`.
///
/// - Lanes: lanelets that cars use, by userOneWay and userBidirectional, else by laneletType. A
///   lanelet that cars use in both directions becomes two lanes, the second with the id suffix
///   kReverse. The centreline is the mean of the bounds, point by point, or middleOf() if their
///   numbers of points differ; it is empty, with a warning, if it cannot be used (posesAlong()).
/// - Links: predecessors and successors.
/// - Junctions: lanelets of the type `intersection` and the turns of <intersection> are connectors
///   in an intersection; in a file without them see markJunctions().
/// - Road area: all lanelets except sidewalks, crosswalks and bus stops. Walkways: sidewalks.
/// - Driving side: config/locations.yaml, else as in an export of this package, else the country of
///   the benchmark id, else the adjacent lanelets of opposite direction.
LaneMap commonRoadLanes(const CommonRoadFile& file, const std::string& location,
                        const DataOptions& options, WarningCounter& warnings);

/// Reads the lanes of the CommonRoad file `path` (readCommonRoadFile(), commonRoadLanes()); the
/// location is the file's name without its extension. Appends one line per kind of defect to
/// `warnings`. Throws as readCommonRoadFile().
LaneMap readCommonRoadMap(const std::string& path, const DataOptions& options,
                          std::vector<std::string>& warnings);

}  // namespace forge
