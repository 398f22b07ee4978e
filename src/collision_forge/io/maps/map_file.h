#pragma once

#include <string>
#include <vector>

#include "collision_forge/base/map/lane_map.h"
#include "collision_forge/io/logs/options.h"

namespace forge {

/// Reads the lanes of a map file: a nuScenes map expansion (JSON), OpenDRIVE, Lanelet2 (.osm) or
/// CommonRoad. The kind follows from the content: a JSON object, or the root element of XML. The
/// location is the file's name without its extension. Values beyond the input limits are left out
/// (keepWithin()). Appends one line per kind of defect to `warnings`, if not null.
///
/// Throws MapError for a file that cannot be opened or is of another kind, for a map without lanes,
/// and as the reader of the kind; InputError for a map beyond the input limits; ConfigError for a
/// location without a driving side, if the kind of file does not contain it.
LaneMap readMapFile(const std::string& path, const DataOptions& options,
                    std::vector<std::string>* warnings = nullptr);

}  // namespace forge
