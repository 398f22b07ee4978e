#pragma once

#include <string>

namespace forge {

/// Walks through the records of a bag, those in its chunks and messages of types that are read too,
/// and throws BagError, naming the path and the byte, for a length or a place that leads out of its
/// record: rosbag and ROS believe them. Throws BagError for a bag of another version than 2.0, too.
/// Encrypted bags, those without an index and what is no bag are left to rosbag, which tells.
void checkBag(const std::string& path);

}  // namespace forge
