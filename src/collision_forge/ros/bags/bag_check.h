#pragma once

#include <string>

namespace forge {

/// Walks through the records of a bag, those in its chunks and messages of types that are read too,
/// and throws BagError, naming the path and the byte, for a length or a place that leads out of its
/// record: rosbag and ROS believe them. Also throws BagError for a file that is no bag, and for a
/// bag of another version than 2.0. Encrypted bags, bags without an index and paths without a file
/// are left to rosbag, which throws for them.
void checkBag(const std::string& path);

}  // namespace forge
