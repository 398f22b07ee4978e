#pragma once

#include <string>

namespace forge {

/// True where the index of a bag, one that rosbag opens, tells of messages at time 0, which means
/// that they have none. rosbag itself leaves these out.
bool hasMessageAtZero(const std::string& path);

}  // namespace forge
