#pragma once

#include <string>

namespace forge {

/// Returns true if the index of the bag has messages at time 0, which means "no time" and which
/// rosbag skips. Precondition: rosbag can open the bag. Returns false for a version other than 2.0.
bool hasMessageAtZero(const std::string& path);

}  // namespace forge
