#include "collision_forge/io/logs/unknown_source.h"

#include <filesystem>
#include <set>

namespace forge {
namespace {

namespace fs = std::filesystem;

/// Returns the endings of a file's name or of the names of a folder's files.
std::set<std::string> endingsAt(const fs::path& path) {
  std::error_code ignored;
  std::set<std::string> endings;
  if (fs::is_regular_file(path, ignored)) return {path.extension().string()};
  for (const auto& entry : fs::directory_iterator(path, ignored)) {
    const std::string name = entry.path().filename().string();
    endings.insert(entry.path().extension().string());
    if (name.find(".tfrecord") != std::string::npos) endings.insert(".tfrecord");
  }
  return endings;
}

}  // namespace

std::string unknownSourceText(const std::string& path) {
  const std::set<std::string> endings = endingsAt(path);
  const auto has = [&](const char* ending) { return endings.count(ending) > 0; };
  if (has(".db3") || has(".mcap")) {
    return path +
           ": is a ROS 2 bag; scripts/ros2_bag converts it to a ROS 1 bag "
           "(docs/foreign_bags.md)";
  }
  std::string text =
      path +
      ": is neither a nuScenes root (no subfolder has scene.json), nor a folder of "
      "ScenarioNet files (sd_*.pkl), nor a bag (.bag), nor a CommonRoad scenario (.xml)";
  if (fs::is_regular_file(path)) {
    text += fs::file_size(path) == 0 ? "; the file is empty" : "; it is a file of another kind";
  } else if (endings.empty()) {
    text += "; the folder is empty";
  }
  if (has(".pkl"))
    text += "; the name of a ScenarioNet file begins with sd_, --source is its folder";
  if (has(".tfrecord"))
    text += "; the converters of ScenarioNet make sd_*.pkl of Waymo's tfrecords";
  return text;
}

}  // namespace forge
