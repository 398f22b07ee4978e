#pragma once

#include <string>
#include <vector>

#include "collision_forge/io/logs/nuscenes_recording.h"
#include "collision_forge/ros/bags/topic_mapping.h"

namespace forge {

/// Reads ego and agents of a bag with foreign message types, by `mapping`, into a recording named
/// after the file, without a location. Categories are the nuScenes categories of the agents'
/// classes, instances are the ids; the frame rate is kept. Drops unusable data, with one line per
/// kind in `warnings` if given: messages without a stamp or with a decreasing one, non-finite poses
/// and agents, agents without size or id, duplicate ids and the ego's id. Throws BagError with
/// path, topic and field for a truncated bag, a file that is no bag, and a bag that contradicts
/// `mapping` (missing topic or field, wrong type or frame_id).
NuScenesRecording readForeignBag(const std::string& path, const TopicMapping& mapping,
                                 const EgoVehicle& ego,
                                 std::vector<std::string>* warnings = nullptr);

}  // namespace forge
