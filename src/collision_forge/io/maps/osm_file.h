#pragma once

#include <map>
#include <string>
#include <unordered_map>
#include <vector>

#include "collision_forge/base/geometry/pose2.h"
#include "collision_forge/io/logs/nuscenes_map_layers.h"
#include "collision_forge/io/logs/options.h"

namespace forge {

/// Tags of an element of OpenStreetMap: values by key.
using OsmTags = std::map<std::string, std::string>;

/// Returns the value of a tag, "" if the element does not have it.
const std::string& tagOf(const OsmTags& tags, const std::string& key);

/// A way, a line of nodes.
struct OsmWay {
  /// Ids, in the way's direction; may be missing in OsmFile::nodes.
  std::vector<std::string> nodes;
  OsmTags tags;
};

/// A relation and its members that are ways.
struct OsmRelation {
  std::string id;
  /// Ids of ways by role, of one role in the file's order; may be missing in the file.
  std::multimap<std::string, std::string> ways;
  OsmTags tags;
};

/// The elements of an OpenStreetMap file that is a Lanelet2 map.
struct OsmFile {
  std::unordered_map<std::string, Vector2> nodes;  ///< m, map frame, by id
  std::map<std::string, OsmWay> ways;              ///< by id
  std::vector<OsmRelation> relations;              ///< in the file's order
};

/// Reads an OpenStreetMap file. Leaves out deleted elements, and nodes without a usable position or
/// beyond InputLimits::max_coordinate.
///
/// Nodes have the position in their tags local_x and local_y, as Autoware writes; if any node has
/// them, nodes without them are left out. If no node has these tags, their lat and lon are
/// projected: UTM coordinates minus the UTM coordinates of the location's origin in `options`, as
/// lanelet2's UtmProjector. Throws MapError for a file that is missing or cannot be read,
/// for malformed XML and for a file without lanelets, and ConfigError if an origin is needed and
/// missing. Adds the nodes that are left out to `warnings`. The location is the file's name without
/// its extension.
OsmFile readOsmFile(const std::string& path, const DataOptions& options, WarningCounter& warnings);

}  // namespace forge
