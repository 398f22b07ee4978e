#pragma once

#include <string>

namespace forge {

/// Checks all lengths and offsets in a bag, including chunks and messages of the types that this
/// package reads, because rosbag and ROS trust them. Throws BagError with path and byte for a
/// length or an offset outside its record, for a file that is no bag, and for a version other
/// than 2.0. Leaves encrypted bags, bags without an index and missing files to rosbag, which
/// throws.
void checkBag(const std::string& path);

}  // namespace forge
