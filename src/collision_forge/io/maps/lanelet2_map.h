#pragma once

#include <string>
#include <vector>

#include "collision_forge/base/map/lane_map.h"
#include "collision_forge/io/logs/options.h"

namespace forge {

/// Reads a Lanelet2 map in an OpenStreetMap file (Poggenhans et al., ITSC 2018, and the formats of
/// Autoware). Elevation is ignored. The location is the file's name without its extension.
///
/// - Lanes: lanelets on which cars may drive, by `participant:*`, else by `subtype`. A lanelet with
///   `one_way=no` becomes two lanes, the second with the id suffix kReverse. The centreline is the
///   relation's `centerline`, else midway between the bounds (middleOf()); it is empty, with a
///   warning, if it cannot be used (posesAlong()). `speed_limit` is in km/h unless it names a unit.
/// - Links: a lane follows another if it starts at the nodes at which the other ends.
/// - Junctions: lanes with a `turn_direction` are connectors in an intersection; in a map without
///   this tag see markJunctions().
/// - Road area: lanelets on the carriageway whose users are cars, buses or bicycles, shoulders,
///   parking areas, `intersection_area` and road markings. Walkways: lanelets and areas of that
///   subtype, and traffic islands.
/// - Driving side: config/locations.yaml, else from neighbours of opposite direction: with traffic
///   on the right, the bound between them is the left bound of both.
///
/// Appends one line per kind of defect to `warnings`; an element with a defect is left out. Throws
/// MapError and ConfigError as readOsmFile().
LaneMap readLanelet2Map(const std::string& path, const DataOptions& options,
                        std::vector<std::string>& warnings);

}  // namespace forge
