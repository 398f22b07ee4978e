#pragma once

#include <string>

namespace forge {

/// Returns true if the index of the bag at `path` has messages with record time 0, which means "no
/// time" and which rosbag skips; false if there are none. rosbag must be able to open the bag;
/// returns false for a file of another format and for a missing one.
bool hasMessageAtZero(const std::string& path);

}  // namespace forge
