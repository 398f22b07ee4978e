#pragma once

#include <string>
#include <vector>

#include "collision_forge/ros/bags/mcap_export.h"

namespace forge {

/// File name by which ROS 2 tools recognise a rosbag2 folder.
inline constexpr char kRosbag2Metadata[] = "metadata.yaml";

/// Writes FOLDER/metadata.yaml of a rosbag2 folder (version 5, ROS 2 Humble; later ones read it,
/// too) whose only file is `mcap`, a file name with extension in the existing `folder`; `made`: the
/// export that wrote this file, in profile ros2. Throws std::runtime_error if it cannot be written.
void writeRosbag2Metadata(const std::string& folder, const std::string& mcap,
                          const McapExport& made);

/// Writes or completes the interface package FOLDER/collision_forge_msgs (package.xml,
/// CMakeLists.txt, msg/TYPE.msg): the types of that package in `topics` (of profile ros2), for
/// colcon in a ROS 2 workspace. Types that are there already are kept. Writes nothing without new
/// types. Throws std::runtime_error if a file of a type is there with another definition, as of a
/// bag of another version, or cannot be written.
void writeRos2Package(const std::string& folder, const std::vector<McapMessages::Topic>& topics);

}  // namespace forge
