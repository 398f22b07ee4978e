#pragma once

#include <string>
#include <vector>

#include "collision_forge/io/logs/nuscenes_recording.h"
#include "collision_forge/ros/bags/topic_mapping.h"

namespace forge {

/// Reads ego and agents of a bag of another source, with a mapping of topics, as a recording named
/// after the file, without a location. Categories follow from the agents' classes, instances are
/// the ids. Keeps the bag's frame rate. Leaves out unusable data, and adds a line for each kind to
/// `warnings`, if given: messages whose stamp is not set or goes back, poses and agents
/// that are not a number, agents without a size or an id, or with that of another one or the ego.
/// Throws BagError naming path, topic and field for a bag that is truncated or no bag, and for
/// one that is not as the mapping says: a topic or field that is not there or of another type,
/// another frame_id.
NuScenesRecording readForeignBag(const std::string& path, const TopicMapping& mapping,
                                 const EgoVehicle& ego,
                                 std::vector<std::string>* warnings = nullptr);

}  // namespace forge
