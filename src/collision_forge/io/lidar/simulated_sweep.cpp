#include "collision_forge/io/lidar/simulated_sweep.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "collision_forge/io/lidar/cloud_injection.h"

namespace forge {
namespace {

constexpr int kRings = 32;
constexpr double kLowest = -30.67 * M_PI / 180.0;   // rad; HDL-32E, ros-drivers/velodyne 32db.yaml
constexpr double kStep = 4.0 / 3.0 * M_PI / 180.0;  // rad between rings
constexpr double kGroundIntensity = 12.0;           // of asphalt, straight down
constexpr std::uint32_t kPointStep = 20;            // bytes

/// Returns the range to the ground; LidarRay::kNoReturn above it and beyond the reach.
float groundRange(const Eigen::Vector3d& direction, const Eigen::Isometry3d& ground, double reach) {
  const Eigen::Vector3d up = ground.linear().col(2);
  const double fall = direction.dot(up);
  if (fall >= 0.0) return LidarRay::kNoReturn;
  const double range = ground.translation().dot(up) / fall;
  return range < reach ? static_cast<float>(range) : LidarRay::kNoReturn;
}

}  // namespace

std::vector<CloudField> nuScenesFields() {
  constexpr std::uint8_t kFloat32 = 7;
  std::vector<CloudField> fields;
  for (const char* name : {"x", "y", "z", "intensity", "ring"}) {
    fields.push_back({name, 4 * static_cast<std::uint32_t>(fields.size()), kFloat32, 1});
  }
  return fields;
}

PointCloud simulateSweep(const std::vector<PosedBody>& bodies, const Eigen::Isometry3d& ground,
                         const SimulatedLidar& lidar, std::uint64_t seed) {
  PointCloud cloud;
  cloud.fields = nuScenesFields();
  cloud.point_step = kPointStep;
  SweepRays sweep;
  sweep.empty_points = EmptyPoints::kLeftOut;
  for (int column = 0; column < lidar.columns; ++column) {
    const double azimuth = -M_PI / 2.0 - 2.0 * M_PI * column / lidar.columns;
    for (int ring = 0; ring < kRings; ++ring) {
      const double elevation = kLowest + kStep * ring;
      const Eigen::Vector3d direction(std::cos(elevation) * std::cos(azimuth),
                                      std::cos(elevation) * std::sin(azimuth), std::sin(elevation));
      LidarRay ray;
      ray.direction = direction.cast<float>();
      ray.range = groundRange(direction, ground, lidar.reach);
      ray.ring = ring;
      ray.point = static_cast<std::uint32_t>(sweep.rays.size());
      sweep.rays.push_back(ray);
      const double fall = std::abs(direction.dot(ground.linear().col(2)));
      const bool is_return = ray.range != LidarRay::kNoReturn;
      const Eigen::Vector3f position =
          is_return ? Eigen::Vector3f(ray.range * ray.direction) : Eigen::Vector3f::Zero();
      const float fields[] = {position.x(), position.y(), position.z(),
                              static_cast<float>(std::round(kGroundIntensity * fall)),
                              static_cast<float>(ring)};
      const auto* bytes = reinterpret_cast<const std::uint8_t*>(fields);
      cloud.data.insert(cloud.data.end(), bytes, bytes + sizeof(fields));
    }
  }
  cloud.width = static_cast<std::uint32_t>(sweep.rays.size());
  cloud.row_step = cloud.width * cloud.point_step;
  const CloudLayout layout(cloud);
  editCloud(cloud, layout, sweep, {bodies, {}, nullptr, lidar.range_noise, seed}, {});
  // Takes out the places of rays without return.
  std::vector<std::uint8_t> returns;
  for (std::size_t i = 0; i < cloud.pointCount(); ++i) {
    const std::uint8_t* point = cloud.pointAt(i);
    if (!layout.position(point).isZero()) returns.insert(returns.end(), point, point + kPointStep);
  }
  cloud.width = static_cast<std::uint32_t>(returns.size() / kPointStep);
  cloud.row_step = cloud.width * cloud.point_step;
  cloud.data = std::move(returns);
  return cloud;
}

NuScenesSensorScene simulatedSensors(const NuScenesRecording& recording) {
  NuScenesSensor lidar;
  lidar.channel = "LIDAR_TOP";
  lidar.modality = "lidar";
  lidar.translation = {0.94, 0.0, 1.84};  // as in nuScenes: x to the right, y ahead
  lidar.rotation = Eigen::AngleAxisd(-M_PI / 2.0, Eigen::Vector3d::UnitZ());
  NuScenesSensorScene scene;
  scene.sensors = {lidar};
  for (const NuScenesEgoPose& pose : recording.ego_poses) {
    scene.files.push_back({pose.timestamp_us, 0, "", 0, 0});
  }
  return scene;
}

PointCloud simulateSweep(const NuScenesRecording& recording, const NuScenesSensor& sensor,
                         std::size_t index) {
  const NuScenesEgoPose& ego = recording.ego_poses[index];
  const Eigen::Isometry3d base = Eigen::Translation3d(ego.translation) * ego.rotation.normalized();
  const Eigen::Isometry3d mounted =
      Eigen::Translation3d(sensor.translation) * sensor.rotation.normalized();
  const Eigen::Isometry3d to_sensor = (base * mounted).inverse();
  const auto after = std::lower_bound(
      recording.frames.begin(), recording.frames.end(), ego.timestamp_us,
      [](const NuScenesFrame& frame, std::int64_t time) { return frame.timestamp_us < time; });
  const NuScenesFrame& frame = after == recording.frames.end() ? recording.frames.back() : *after;
  std::vector<PosedBody> bodies;
  for (const NuScenesAnnotation& object : frame.annotations) {
    // Back from the next frame by its velocity, which was derived from the two frames around it.
    const double time = static_cast<double>(ego.timestamp_us - frame.timestamp_us) * 1e-6;
    const Eigen::Vector3d bottom = object.translation + time * object.velocity -
                                   Eigen::Vector3d(0.0, 0.0, object.size.z() / 2.0);
    const AgentClass agent_class =
        agentClassOfCategory(object.category).value_or(AgentClass::kStaticObject);
    Eigen::Vector3d size = object.size;
    if (size.z() == 0.0) size.z() = typicalHeight(agent_class, {size.x(), size.y()});  // unknown
    PosedBody body;
    body.body = lidarBodyOf(agent_class, size, bottom.x() + bottom.y());
    body.end = to_sensor * Eigen::Translation3d(bottom) * object.rotation.normalized();
    body.begin = body.end;
    body.brightness = brightnessOf(object.instance, 0);
    bodies.push_back(std::move(body));
  }
  return simulateSweep(bodies, mounted.inverse(), {}, static_cast<std::uint64_t>(ego.timestamp_us));
}

}  // namespace forge
