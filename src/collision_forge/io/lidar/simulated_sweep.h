#pragma once

#include <cstdint>
#include <vector>

#include "collision_forge/io/lidar/point_cloud.h"
#include "collision_forge/io/lidar/surface_returns.h"
#include "collision_forge/io/logs/nuscenes_recording.h"
#include "collision_forge/io/logs/nuscenes_sensors.h"

namespace forge {

/// A spinning lidar of 32 rings over flat ground.
struct SimulatedLidar {
  int columns = 360;          ///< azimuth steps of a turn, clockwise from straight behind
  double range_noise = 0.02;  ///< m, standard deviation of the range of returns from bodies
  double reach = 80.0;        ///< m; the ground returns nothing beyond it
};

/// Returns the fields x, y, z, intensity and ring, all float32: a point of a `.pcd.bin` of
/// nuScenes.
std::vector<CloudField> nuScenesFields();

/// Simulates one turn of 32 rings with the elevations of an HDL-32E (-30.67 degrees and up in steps
/// of 4/3 degrees; ring 0 is the lowest) among `bodies`, whose returns follow the model `materials`
/// of SurfaceReturns. All rays have the time of the stamp. The cloud is unorganised, with
/// nuScenesFields(), column by column, in the sensor's frame as nuScenes defines it: x to the
/// right, y ahead, z up. Rays without return are left out. `bodies`: in the sensor's frame.
/// `ground`: pose of a frame on the ground in the sensor's frame, its z axis up. `seed`: of noise,
/// lost returns and brightness. The same input gives the same bytes.
PointCloud simulateSweep(const std::vector<PosedBody>& bodies, const Eigen::Isometry3d& ground,
                         const SimulatedLidar& lidar, std::uint64_t seed);

/// Returns a LIDAR_TOP as nuScenes mounts it, with one file without a name at the time of every ego
/// pose, in their order; simulateSweep() makes the content.
NuScenesSensorScene simulatedSensors(const NuScenesRecording& recording);

/// Simulates the sweep of `sensor` at the ego pose recording.ego_poses[index], among the annotated
/// objects of the first frame not before that pose, else of the last frame. The objects are moved
/// along their annotated velocity to the time of the pose, forwards or backwards, and stand still
/// during the sweep. The ground is the xy plane of base_link. Uses a default SimulatedLidar; the
/// seed is the time of the pose, us. `recording` must have a frame.
PointCloud simulateSweep(const NuScenesRecording& recording, const NuScenesSensor& sensor,
                         std::size_t index);

}  // namespace forge
