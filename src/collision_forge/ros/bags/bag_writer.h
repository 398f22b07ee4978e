#pragma once

#include <functional>
#include <string>

#include "collision_forge/base/map/lane_map.h"
#include "collision_forge/io/logs/nuscenes_recording.h"
#include "collision_forge/ros/bags/sensor_writer.h"

namespace forge {

/// Writes one scene as an LZ4 bag with the recorded timestamps: /tf (map -> base_link) and /odom at
/// every ego pose, /agents and /annotation_markers at every frame, /lane_map once, latched. Writes
/// a temporary file and renames it. `sensors`, unless null, are written by SensorWriter;
/// `write_more`, if set, writes further messages at the end. Throws std::runtime_error with the
/// path.
SensorCounts writeBag(const std::string& path, const NuScenesRecording& recording,
                      const LaneMap& map, const NuScenesSensorScene* sensors = nullptr,
                      const std::function<void(NewBag&)>& write_more = {});

}  // namespace forge
