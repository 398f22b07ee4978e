#pragma once

#include <cstdint>
#include <vector>

#include "collision_forge/io/lidar/point_cloud.h"
#include "collision_forge/io/lidar/surface_returns.h"
#include "collision_forge/io/logs/nuscenes_recording.h"
#include "collision_forge/io/logs/nuscenes_sensors.h"

namespace forge {

/// A spinning lidar over flat ground.
struct SimulatedLidar {
  int columns = 360;          ///< azimuth steps of a turn, clockwise from straight behind
  double range_noise = 0.02;  ///< m, standard deviation
  double reach = 80.0;        ///< m
};

/// Returns the fields x, y, z, intensity and ring, all float32: a point of a `.pcd.bin` of
/// nuScenes.
std::vector<CloudField> nuScenesFields();

/// Simulates one turn of 32 rings with the elevations of an HDL-32E among `bodies`, which return by
/// SurfaceReturns' model `materials`. Rays without return are left out. `ground`: pose of a frame
/// on the ground in the sensor's frame, its z axis up. The same input gives the same bytes.
PointCloud simulateSweep(const std::vector<PosedBody>& bodies, const Eigen::Isometry3d& ground,
                         const SimulatedLidar& lidar, std::uint64_t seed);

/// Returns a LIDAR_TOP as nuScenes mounts it, with a file to simulate at every ego pose.
NuScenesSensorScene simulatedSensors(const NuScenesRecording& recording);

/// Simulates the sweep of `sensor` at the ego pose `index`, among the annotated objects, whose
/// poses are interpolated between frames. The ground is the xy plane of base_link.
PointCloud simulateSweep(const NuScenesRecording& recording, const NuScenesSensor& sensor,
                         std::size_t index);

}  // namespace forge
