#pragma once

#include <string>
#include <vector>

#include "collision_forge/io/logs/nuscenes_recording.h"
#include "collision_forge/ros/bags/topic_mapping.h"

namespace forge {

/// Reads ego and agents of the bag at `path` with foreign message types, by `mapping`, into a
/// recording named after the file, without a location. Poses are transformed to the mapping's
/// map_frame by the transforms of the bag; ego poses are of base_link, `ego` gives its offset to
/// the box centre. Timestamps are header stamps. Categories are the nuScenes categories of the
/// agents' classes, instances are the ids; the frame rate is kept. Velocities that the mapping
/// lacks are derived (deriveVelocities()).
///
/// Drops unusable data and appends one line per kind to `warnings`, if given: messages without a
/// stamp, with one not after the previous message's or without transforms at it, non-finite poses
/// and agents, agents without size or id, with the id of an earlier agent of the frame, or with the
/// ego's id. A non-finite velocity becomes zero. Throws BagError with path, topic and field for a
/// truncated bag, a file that is no bag, a bag that contradicts `mapping` (missing topic or field,
/// wrong type or frame_id), a bag without a usable ego pose or frame, and two different poses of
/// the ego at one time.
NuScenesRecording readForeignBag(const std::string& path, const TopicMapping& mapping,
                                 const EgoVehicle& ego,
                                 std::vector<std::string>* warnings = nullptr);

}  // namespace forge
