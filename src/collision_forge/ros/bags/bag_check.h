#pragma once

#include <string>

namespace forge {

/// Checks all lengths and offsets in the records of a bag, also in chunks and in messages of the
/// types that are read, since rosbag and ROS do not check them. Throws BagError with path and byte
/// if one leads out of its record, for a file that is no bag, and for a version other than 2.0.
/// Ignores encrypted bags, bags without an index and missing files: rosbag throws for them.
void checkBag(const std::string& path);

}  // namespace forge
