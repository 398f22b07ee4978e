#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "collision_forge/base/map/geo_point.h"

namespace forge {

/// One message of the inertial measurement unit.
struct NuScenesInertia {
  std::int64_t timestamp_us = 0;
  Eigen::Vector3d acceleration;    ///< m/s^2, in the frame of the unit, with gravity
  Eigen::Quaterniond orientation;  ///< of the unit; the yaw of the reference is arbitrary
  Eigen::Vector3d rotation_rate;   ///< rad/s, in the frame of the unit
};

/// One message of the localisation of the ego.
struct NuScenesPlace {
  std::int64_t timestamp_us = 0;
  Eigen::Vector3d position;  ///< m, in the map frame
};

/// Reads `dataroot`/can_bus/`scene`_ms_imu.json (CAN bus expansion of nuScenes, 100 Hz). nullopt if
/// the file does not exist. Throws NuScenesError for a malformed one.
std::optional<std::vector<NuScenesInertia>> readInertia(const std::string& dataroot,
                                                        const std::string& scene);

/// Reads `dataroot`/can_bus/`scene`_pose.json (50 Hz); otherwise as readInertia().
std::optional<std::vector<NuScenesPlace>> readPlaces(const std::string& dataroot,
                                                     const std::string& scene);

/// Returns latitude and longitude of a position (m, x east, y north) on a nuScenes map, whose
/// origin is its south-western corner. nullopt for a map of another name. Source of the origins and
/// of the sphere of 6,378,137 m: nuscenes-devkit, python-sdk/nuscenes/scripts/export_poses.py,
/// which states no accuracy.
std::optional<GeoPoint> geoPointOn(const std::string& location, const Eigen::Vector2d& position);

}  // namespace forge
