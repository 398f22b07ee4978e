#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <stdexcept>
#include <string>

#include "collision_forge/io/logs/nuscenes_json.h"

namespace forge {

inline constexpr const char* kHexToken = "0123456789abcdef0123456789abcdef";

/// A temporary folder, deleted when the test ends.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "nuscenes_XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make " + name);
    path_ = name;
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() { std::filesystem::remove_all(path_); }

  std::string path() const { return path_.string(); }
  std::string write(const std::string& name, const std::string& content) const {
    std::filesystem::create_directories((path_ / name).parent_path());
    std::ofstream(path_ / name) << content;
    return (path_ / name).string();
  }

 private:
  std::filesystem::path path_;
};

/// Replaces the first occurrence; throws if there is none.
inline void replaceIn(std::string& text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos) throw std::logic_error("fixture has no " + from);
  text.replace(at, from.size(), to);
}

/// Returns the message of the Error that `call` throws; "" if it throws none.
template <typename Error = NuScenesError, typename Call>
std::string errorOf(const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

/// Two scenes. "scene-0001": a car (at 10 m, then 12 m farther in 1 s) in three frames, a
/// pedestrian in one; the ego heads along +y at 8 m/s; a camera whose ego poses are in no table.
/// "scene-0002": one frame without annotations.
inline std::map<std::string, std::string> tinyTables() {
  const std::string hex = kHexToken;
  return {
      {"log", R"([{"token": "log", "location": "left-town", "logfile": "x"}])"},
      {"scene",
       R"([{"token": "s1", "log_token": "log", "nbr_samples": 3, "name": "scene-0001",
            "description": "A car"},
           {"description": "", "name": "scene-0002", "log_token": "log", "token": "s2"}])"},
      {"sensor", R"([{"token": "lidar", "channel": "LIDAR_TOP", "modality": "lidar"},
                     {"token": "camera", "channel": "CAM_FRONT", "modality": "camera"}])"},
      {"calibrated_sensor",
       R"([{"token": "lidar-here", "sensor_token": "lidar", "camera_intrinsic": []},
           {"token": "camera-here", "sensor_token": "camera", "camera_intrinsic": [[1, 2], [3]]}])"},
      {"category", R"([{"token": "c-car", "name": "vehicle.car"},
                       {"token": "c-ped", "name": "human.pedestrian.adult"}])"},
      {"attribute", R"([{"token": "moving", "name": "vehicle.moving"}])"},
      {"instance", R"([{"token": ")" + hex + R"(", "category_token": "c-car"},
                       {"token": "ped", "category_token": "c-ped"}])"},
      {"sample", R"([{"token": "f2", "timestamp": 1533000001000000, "scene_token": "s1"},
                     {"token": "f0", "timestamp": 1533000000000001, "scene_token": "s1"},
                     {"token": "f1", "timestamp": 1533000000500000, "scene_token": "s1"},
                     {"token": "g0", "timestamp": 1533000009000000, "scene_token": "s2"}])"},
      {"sample_annotation", R"([{"token": "a0", "sample_token": "f0", "instance_token": ")" + hex +
                                R"(",
            "attribute_tokens": ["moving"], "translation": [10.0, 50, 1],
            "size": [2.0, 4.5, 1.6], "rotation": [1, 0, 0, 0], "visibility_token": "4"},
           {"rotation": [1, 0, 0, 0], "size": [2.0, 4.5, 1.6], "translation": [15.0, 50, 1],
            "attribute_tokens": [], "instance_token": ")" +
                                hex + R"(", "sample_token": "f1",
            "token": "a1"},
           {"token": "p1", "sample_token": "f1", "instance_token": "ped", "attribute_tokens": [],
            "translation": [0, 0, 1], "size": [0.6, 0.7, 1.8], "rotation": [0, 0, 0, 2]},
           {"token": "a2", "sample_token": "f2", "instance_token": ")" +
                                hex + R"(",
            "attribute_tokens": ["moving"], "translation": [2.2e1, 50, 1],
            "size": [2.0, 4.5, 1.6], "rotation": [1, 0, 0, 0]}])"},
      {"sample_data",
       R"([{"token": "d2", "sample_token": "f2", "ego_pose_token": "e2",
            "calibrated_sensor_token": "lidar-here"},
           {"token": "d0", "sample_token": "f0", "ego_pose_token": "e0",
            "calibrated_sensor_token": "lidar-here"},
           {"token": "x0", "sample_token": "f0", "ego_pose_token": "of the camera",
            "calibrated_sensor_token": "camera-here"},
           {"token": "d1", "sample_token": "f1", "ego_pose_token": "e1",
            "calibrated_sensor_token": "lidar-here"},
           {"token": "h0", "sample_token": "g0", "ego_pose_token": "k0",
            "calibrated_sensor_token": "lidar-here"}])"},
      {"ego_pose",
       R"([{"token": "e0", "timestamp": 1533000000000001,
            "rotation": [0.7071067811865476, 0, 0, 0.7071067811865476], "translation": [100, 200, 0]},
           {"token": "e1", "timestamp": 1533000000500001,
            "rotation": [0.7071067811865476, 0, 0, 0.7071067811865476], "translation": [100, 204, 0]},
           {"token": "e2", "timestamp": 1533000001000001,
            "rotation": [0.7071067811865476, 0, 0, 0.7071067811865476], "translation": [100, 208, 0]},
           {"token": "k0", "timestamp": 1533000009000000, "rotation": [1, 0, 0, 0],
            "translation": [0, 0, 0]}])"},
  };
}

inline void writeTables(const TemporaryFolder& folder,
                        const std::map<std::string, std::string>& tables) {
  for (const auto& [name, content] : tables) folder.write("v1.0-tiny/" + name + ".json", content);
}

}  // namespace forge
