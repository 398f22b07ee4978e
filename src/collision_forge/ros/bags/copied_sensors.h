#pragma once

#include <rosbag/bag.h>

#include <cstddef>

#include "collision_forge/base/scene/scene.h"
#include "collision_forge/ros/bags/bag_file.h"
#include "collision_forge/ros/bags/topic_mapping.h"

namespace forge {

/// Copies the messages of package sensor_msgs (clouds, pictures, camera infos, ...) of a bag of
/// another stack into a bag of this suite, byte by byte, on the same topics. Before the first of
/// them writes one latched /tf_static with the static transforms below the ego's frame
/// (EgoMapping::child_frame_id), unless there are none. If this frame has another name than
/// base_link, it becomes a child of base_link: without rotation, and translated by
/// `ego.center_offset` along x if EgoMapping::reference is kBoxMiddle, else not. Record times are
/// the header stamps; messages whose stamp is 0 are left out. Returns the number of copied
/// messages, without /tf_static; 0 for a bag without sensors, from which nothing is written. Throws
/// BagError, without a path, if a message has no header or cannot be copied.
std::size_t copySensors(const rosbag::Bag& source, const TopicMapping& mapping,
                        const EgoVehicle& ego, NewBag& target);

}  // namespace forge
