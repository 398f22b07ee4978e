#pragma once

#include <string>
#include <vector>

#include "collision_forge/base/map/lane_map.h"
#include "collision_forge/io/logs/nuscenes_map_layers.h"
#include "collision_forge/io/maps/open_drive_road.h"

namespace forge {

/// One connection of a junction.
struct OpenDriveConnection {
  std::string junction;
  std::string incoming;    ///< id of a road
  std::string connecting;  ///< id of a road; in a direct junction the linked road
  bool at_end = false;     ///< the connecting road meets the incoming road at its end
  std::vector<std::pair<int, int>> lanes;  ///< ids of linked lanes: incoming, connecting
};

/// Roads and connections of one file.
struct OpenDriveNetwork {
  std::string path;  ///< of the file, for messages
  std::vector<OpenDriveRoad> roads;
  std::vector<OpenDriveConnection> connections;
};

/// Returns the lanes and areas of a network; see readOpenDriveMap(). `resolution`: m between the
/// poses of a centreline, > 0. Leaves out lane sections beyond `limits`. Adds defects to
/// `warnings`. The location is not set. Throws InputError for more points than `limits` allow.
LaneMap laneMapOf(const OpenDriveNetwork& network, double resolution, const InputLimits& limits,
                  WarningCounter& warnings);

}  // namespace forge
