#pragma once

#include <string>

namespace forge {

/// Checks all lengths and offsets in the bag at `path`, including chunks and messages of the types
/// that this package reads, because rosbag and ROS trust them; reads the whole file. Throws
/// BagError with path and byte for a length or an offset outside its record, for a file that is no
/// bag, and for a version other than 2.0. Returns without a check of the rest for encrypted bags,
/// bags without an index, files that hold only the first line, and missing files: rosbag throws for
/// them.
void checkBag(const std::string& path);

}  // namespace forge
