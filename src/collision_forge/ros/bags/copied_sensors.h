#pragma once

#include <rosbag/bag.h>

#include <cstddef>

#include "collision_forge/base/scene/scene.h"
#include "collision_forge/ros/bags/bag_file.h"
#include "collision_forge/ros/bags/topic_mapping.h"

namespace forge {

/// Copies the messages of package sensor_msgs (clouds, pictures, camera infos, ...) of a bag of
/// another stack into a bag of this suite, byte by byte, and the static transforms below the ego's
/// frame (EgoMapping::child_frame_id), which becomes a child of base_link if it has another name.
/// Record times are the header stamps; messages whose stamp is 0 are left out. `ego` gives the
/// offset between base_link and the box centre. Returns the number of copied messages. Throws
/// BagError, without a path, if a message has no header or cannot be copied.
std::size_t copySensors(const rosbag::Bag& source, const TopicMapping& mapping,
                        const EgoVehicle& ego, NewBag& target);

}  // namespace forge
