#pragma once

#include <functional>
#include <string>

#include "collision_forge/base/map/lane_map.h"
#include "collision_forge/io/logs/nuscenes_recording.h"
#include "collision_forge/ros/bags/sensor_writer.h"

namespace forge {

/// Writes one scene as an LZ4 bag to `path` with the recorded timestamps as stamps and record
/// times: /tf (map -> base_link) and /odom at every ego pose, /agents, /annotation_markers and
/// /agent_objects at every frame, /lane_map once, latched; if the recording has them, /ego_vehicle
/// once and /traffic_lights with markers at the time of every state of a light, latched. Nothing is
/// earlier than the first ego pose or frame: earlier states of lights get its time. Writes a
/// temporary file and renames it.
///
/// `map`: the lanes for /lane_map. `sensors`, unless null, are written by SensorWriter.
/// `write_more`, unless empty, is called once before the bag is closed and may write further
/// messages. Returns the counts of SensorWriter, all 0 without sensors. Throws BagError for a
/// recording without ego poses or frames, and std::runtime_error with the path if the bag cannot be
/// written.
SensorCounts writeBag(const std::string& path, const NuScenesRecording& recording,
                      const LaneMap& map, const NuScenesSensorScene* sensors = nullptr,
                      const std::function<void(NewBag&)>& write_more = {});

}  // namespace forge
