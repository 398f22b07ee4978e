#pragma once

#include <string>

namespace forge {

/// Returns true if the index of the bag has messages at time 0, which means "no time" and which
/// rosbag skips. rosbag must be able to open the bag.
bool hasMessageAtZero(const std::string& path);

}  // namespace forge
