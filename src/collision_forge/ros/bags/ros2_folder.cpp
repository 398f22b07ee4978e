#include "collision_forge/ros/bags/ros2_folder.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>
#include <stdexcept>

#include "collision_forge/base/files/aside_file.h"
#include "collision_forge/io/json/json_line.h"
#include "collision_forge/ros/bags/ros2_message.h"

namespace forge {
namespace {

namespace fs = std::filesystem;

std::string packageXml(const std::set<std::string>& packages) {
  std::string depends;
  for (const std::string& name : packages) depends += "  <depend>" + name + "</depend>\n";
  return R"(<?xml version="1.0"?>
<package format="3">
  <name>)" +
         std::string(kRos2Package) +
         R"(</name>
  <version>1.0.0</version>
  <description>Messages of collision_forge in ROS 2, generated from exported bags.</description>
  <maintainer email="maintainers@collision-forge.invalid">collision_forge maintainers</maintainer>
  <license>BSD</license>
  <buildtool_depend>ament_cmake</buildtool_depend>
  <buildtool_depend>rosidl_default_generators</buildtool_depend>
)" + depends +
         R"(  <exec_depend>rosidl_default_runtime</exec_depend>
  <member_of_group>rosidl_interface_packages</member_of_group>
  <export>
    <build_type>ament_cmake</build_type>
  </export>
</package>
)";
}

std::string cmakeLists(const std::set<std::string>& packages) {
  std::string find;
  std::string names;
  for (const std::string& name : packages) {
    find += "find_package(" + name + " REQUIRED)\n";
    names += " " + name;
  }
  return "cmake_minimum_required(VERSION 3.8)\nproject(" + std::string(kRos2Package) +
         ")\n\nfind_package(ament_cmake REQUIRED)\nfind_package(rosidl_default_generators "
         "REQUIRED)\n" +
         find +
         "file(GLOB messages RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} msg/*.msg)\n"
         "rosidl_generate_interfaces(${PROJECT_NAME} ${messages} DEPENDENCIES" +
         names + ")\nament_export_dependencies(rosidl_default_runtime)\nament_package()\n";
}

std::string textOf(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// Adds the packages of the field types in a message definition.
void addPackages(const std::string& definition, std::set<std::string>& packages) {
  std::istringstream lines(definition);
  for (std::string line; std::getline(lines, line);) {
    const std::string type = line.substr(0, line.find_first_of(" #["));
    const std::size_t slash = type.find('/');
    if (slash != std::string::npos) packages.insert(type.substr(0, slash));
  }
  packages.erase(kRos2Package);
}

}  // namespace

void writeRosbag2Metadata(const std::string& folder, const std::string& mcap,
                          const McapExport& made) {
  std::uint64_t count = 0;
  for (const McapMessages::Topic& topic : made.topics) count += topic.written;
  JsonLineWriter file;  // YAML contains JSON
  const auto put_time = [&](const char* key, const char* unit, std::uint64_t value) {
    file.beginObject(key);
    file.count(unit, value);
    file.endObject();
  };
  const auto put_totals = [&] {
    put_time("duration", "nanoseconds", made.end.toNSec() - made.begin.toNSec());
    put_time("starting_time", "nanoseconds_since_epoch", made.begin.toNSec());
    file.count("message_count", count);
  };
  constexpr int kVersion = 5;  // of ROS 2 Humble
  file.beginObject();
  file.beginObject("rosbag2_bagfile_information");
  file.count("version", kVersion);
  file.text("storage_identifier", "mcap");
  file.texts("relative_file_paths", {mcap});
  put_totals();
  file.text("compression_format", "");
  file.text("compression_mode", "");
  file.beginArray("topics_with_message_count");
  for (const McapMessages::Topic& topic : made.topics) {
    file.beginObject();
    file.beginObject("topic_metadata");
    file.text("name", topic.name);
    file.text("type", topic.type);
    file.text("serialization_format", kRos2Encoding);
    file.text("offered_qos_profiles", topic.qos);
    file.endObject();
    file.count("message_count", topic.written);
    file.endObject();
  }
  file.endArray();
  file.beginArray("files");
  file.beginObject();
  file.text("path", mcap);
  put_totals();
  file.endObject();
  file.endArray();
  file.endObject();
  file.endObject();
  writeText((fs::path(folder) / kRosbag2Metadata).string(), file.line() + "\n");
}

void writeRos2Package(const std::string& folder, const std::vector<McapMessages::Topic>& topics) {
  const fs::path package = fs::path(folder) / kRos2Package;
  const fs::path messages = package / "msg";
  bool is_changed = false;
  for (const McapMessages::Topic& topic : topics) {
    for (const auto& [name, text] : ownRos2Types(topic.type, topic.definition)) {
      const fs::path path = messages / (name + ".msg");
      if (!fs::exists(path)) {
        fs::create_directories(messages);
        writeText(path.string(), text);
        is_changed = true;
      } else if (textOf(path) != text) {
        throw std::runtime_error(path.string() + ": has another definition than the bag's " +
                                 topic.name + "; export the bag to another folder");
      }
    }
  }
  if (!is_changed) return;
  std::set<std::string> packages;
  for (const fs::directory_entry& entry : fs::directory_iterator(messages)) {
    addPackages(textOf(entry.path()), packages);
  }
  writeText((package / "package.xml").string(), packageXml(packages));
  writeText((package / "CMakeLists.txt").string(), cmakeLists(packages));
}

}  // namespace forge
