#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "collision_forge/io/logs/nuscenes_json.h"

namespace forge {

/// A sensor as it was mounted in a scene.
struct NuScenesSensor {
  std::string channel;   ///< as "LIDAR_TOP"
  std::string modality;  ///< "lidar", "camera" or "radar"
  /// m, origin of the sensor's frame in base_link.
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();
  /// From the sensor's frame to base_link.
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  /// Camera matrix, pixels, row by row; zeros for other sensors.
  std::array<double, 9> intrinsic{};
};

/// One file of a sensor: a lidar sweep, the returns of a radar, or a picture.
struct NuScenesSensorFile {
  std::int64_t timestamp_us = 0;  ///< microseconds since 1970
  std::uint32_t sensor = 0;       ///< index into NuScenesSensorScene::sensors
  std::string
      path;  ///< path of the file, with the data root; empty: to simulate (simulatedSensors())
  std::uint32_t width = 0;   ///< pixels, of pictures; 0 for sweeps and radars
  std::uint32_t height = 0;  ///< pixels, of pictures; 0 for sweeps and radars
};

/// The sensor data of one scene: keyframes and sweeps.
struct NuScenesSensorScene {
  std::string dataroot;  ///< folder of the nuScenes root; empty if all files are simulated
  std::vector<NuScenesSensor> sensors;    ///< in the order of their first files in the table
  std::vector<NuScenesSensorFile> files;  ///< by time, then by sensor
};

/// Reads from the tables in `dataroot`/`version` which files the sensors of the scenes `only`
/// (names; empty: all) recorded; returns them by the scene's name. An unknown name in `only` is
/// ignored. The files are not opened. Throws NuScenesError for a table that is missing or
/// malformed, a row with a missing field or a field of another type, and a token that refers to no
/// row.
std::map<std::string, NuScenesSensorScene> readNuScenesSensors(
    const std::string& dataroot, const std::string& version, const std::vector<std::string>& only);

}  // namespace forge
