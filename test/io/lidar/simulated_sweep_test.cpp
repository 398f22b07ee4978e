#include "collision_forge/io/lidar/simulated_sweep.h"

#include <gtest/gtest.h>

namespace forge {
namespace {

NuScenesRecording recording() {
  NuScenesRecording recording;
  recording.ego_poses.resize(2);
  recording.ego_poses[1].timestamp_us = 500000;
  recording.frames.resize(2);
  recording.frames[1].timestamp_us = 500000;
  for (NuScenesFrame& frame : recording.frames) {
    NuScenesAnnotation& car = frame.annotations.emplace_back();
    car.instance = "car";
    car.category = "vehicle.car";
    car.size = {4.5, 1.9, 1.5};
    car.velocity = {10.0, 0.0, 0.0};
    car.translation = {10.0 + 10.0 * frame.timestamp_us * 1e-6, 0.0, 0.75};
  }
  return recording;
}

/// Returns the number of points ahead (y of the sensor) that are above the ground.
std::size_t pointsOnCar(const PointCloud& cloud, double from, double to) {
  const CloudLayout layout(cloud);
  std::size_t count = 0;
  for (std::size_t i = 0; i < cloud.pointCount(); ++i) {
    const Eigen::Vector3d point = layout.position(cloud.pointAt(i));
    if (point.z() > -1.7 && point.y() > from && point.y() < to) ++count;
  }
  return count;
}

TEST(SimulatedSweep, ShowsTheAnnotatedObjectsAtTheirPlace) {
  const NuScenesRecording scene = recording();
  const NuScenesSensorScene sensors = simulatedSensors(scene);
  ASSERT_EQ(sensors.files.size(), 2u);
  const PointCloud first = simulateSweep(scene, sensors.sensors[0], 0);
  EXPECT_GT(pointsOnCar(first, 6.0, 12.0), 40u);
  EXPECT_EQ(pointsOnCar(first, 12.0, 80.0), 0u);
  const PointCloud second = simulateSweep(scene, sensors.sensors[0], 1);
  EXPECT_EQ(pointsOnCar(second, 6.0, 11.0), 0u);
  EXPECT_GT(pointsOnCar(second, 11.0, 17.0), 20u);
}

TEST(SimulatedSweep, AnObjectOfUnknownHeightHasATypicalOne) {
  NuScenesRecording scene = recording();  // cars of a typical height
  const NuScenesSensor lidar = simulatedSensors(scene).sensors[0];
  const PointCloud known = simulateSweep(scene, lidar, 0);
  for (NuScenesFrame& frame : scene.frames) {
    frame.annotations[0].size.z() = frame.annotations[0].translation.z() = 0.0;
  }
  EXPECT_EQ(simulateSweep(scene, lidar, 0).data, known.data);
}

TEST(SimulatedSweep, RepeatsItsBytes) {
  const NuScenesRecording scene = recording();
  const NuScenesSensor lidar = simulatedSensors(scene).sensors[0];
  EXPECT_EQ(simulateSweep(scene, lidar, 0).data, simulateSweep(scene, lidar, 0).data);
  EXPECT_NE(simulateSweep(scene, lidar, 0).data, simulateSweep(scene, lidar, 1).data);
}

}  // namespace
}  // namespace forge
