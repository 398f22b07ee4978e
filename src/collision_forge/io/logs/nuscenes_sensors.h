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
  std::string channel;                                    ///< as "LIDAR_TOP"
  std::string modality;                                   ///< "lidar", "camera" or "radar"
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();  ///< m, in base_link
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  std::array<double, 9> intrinsic{};  ///< camera matrix, row by row; zero without one
};

/// One file of a sensor: a sweep or a picture.
struct NuScenesSensorFile {
  std::int64_t timestamp_us = 0;
  std::uint32_t sensor = 0;  ///< index into NuScenesSensorScene::sensors
  std::string path;          ///< of the file; empty: to simulate (simulatedSensors())
  std::uint32_t width = 0;   ///< pixels, of pictures
  std::uint32_t height = 0;
};

/// The sensor data of one scene: keyframes and sweeps.
struct NuScenesSensorScene {
  std::string dataroot;  ///< folder of the files; empty: all are simulated
  std::vector<NuScenesSensor> sensors;
  std::vector<NuScenesSensorFile> files;  ///< by time, then by sensor
};

/// Reads from the tables in `dataroot`/`version` which files the sensors of the scenes `only`
/// (empty: all) recorded; returns them by the scene's name. The files are not opened. Throws
/// NuScenesError as readNuScenesTables().
std::map<std::string, NuScenesSensorScene> readNuScenesSensors(
    const std::string& dataroot, const std::string& version, const std::vector<std::string>& only);

}  // namespace forge
