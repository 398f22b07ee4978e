#pragma once

#include <string>

namespace forge {

/// Returns true if the index of a bag lists messages at time 0 (no time), which rosbag leaves out.
/// `path` must be a bag that rosbag can open.
bool hasMessageAtZero(const std::string& path);

}  // namespace forge
