#pragma once

#include <string>

#include "collision_forge/base/map/lane_map.h"
#include "collision_forge/io/logs/nuscenes_recording.h"

namespace forge {

/// Writes one scene as an LZ4 bag with the recorded timestamps: /tf (map -> base_link) and /odom at
/// every ego pose; /agents, /annotation_markers and /agent_objects at every frame; /lane_map and,
/// if the ego's size is known, /ego_vehicle once, latched. Writes a temporary file and renames it.
/// Throws as NewBag, and BagError for a recording without ego poses or frames.
void writeBag(const std::string& path, const NuScenesRecording& recording, const LaneMap& map);

}  // namespace forge
