#pragma once

#include <string>
#include <vector>

#include "collision_forge/base/map/lane_map.h"
#include "collision_forge/io/logs/nuscenes_map_layers.h"
#include "collision_forge/io/maps/open_drive_road.h"

namespace forge {

/// One connection of a junction.
struct OpenDriveConnection {
  std::string junction;    ///< id of the junction
  std::string incoming;    ///< id of the road that leads in
  std::string connecting;  ///< id of the connecting road; in a direct junction, of the linked road
  /// The end of the connecting road that meets the incoming road: true: its end, false: its start.
  bool at_end = false;
  /// Pairs of ids of linked lanes: in the incoming road, in the connecting road.
  std::vector<std::pair<int, int>> lanes;
};

/// Roads and connections of one file.
struct OpenDriveNetwork {
  std::string path;  ///< path of the file, for messages
  std::vector<OpenDriveRoad> roads;
  std::vector<OpenDriveConnection> connections;
};

/// Returns the lanes and areas of a network, map frame, metres; see readOpenDriveMap().
/// `resolution`: m between the poses of a centreline, > 0. Leaves out lane sections beyond
/// `limits`. Adds defects to `warnings`. LaneMap::location is not set; the driving side is the side
/// of most roads. Throws InputError for more points than `limits` allow.
LaneMap laneMapOf(const OpenDriveNetwork& network, double resolution, const InputLimits& limits,
                  WarningCounter& warnings);

}  // namespace forge
