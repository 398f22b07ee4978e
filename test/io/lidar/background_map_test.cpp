#include "collision_forge/io/lidar/background_map.h"

#include <gtest/gtest.h>

#include <cmath>

#include "io/lidar/made_up_cloud.h"

namespace forge {
namespace {

constexpr SweepTiming kTiming{100.0, 0.1};

/// Ground, and a wall 20 m ahead.
double wallRange(const Eigen::Vector3d& direction) {
  return direction.x() > 0.3 ? std::min(20.0 / direction.x(), groundRangeOf(direction))
                             : groundRangeOf(direction);
}

/// The wall from y = -20, 0 and 20 m.
BackgroundMap mapOfWall(const std::vector<VacatedBox>& movers) {
  BackgroundMap map;
  MadeUpLidar lidar;
  lidar.columns = 720;
  lidar.rings = 60;
  lidar.step = 0.01;
  const PointCloud cloud = madeUpCloud(lidar, wallRange);
  const CloudLayout layout(cloud);
  for (const double y : {-20.0, 0.0, 20.0}) {
    map.add(cloud, layout, raysOf(cloud, layout, kTiming),
            Eigen::Isometry3d(Eigen::Translation3d(0.0, y, 1.8)), movers);
  }
  map.finish();
  return map;
}

TEST(BackgroundMap, RaysEndOnTheGroundOrOnAnObstacle) {
  const BackgroundMap map = mapOfWall({});
  double intensity = 0.0;
  const Eigen::Vector3d sensor(0.0, 0.0, 1.8);
  const Eigen::Vector3d down = Eigen::Vector3d(10.0, 0.0, -1.8).normalized();
  EXPECT_NEAR(map.rangeFrom(sensor, down, 3.0, intensity), std::hypot(10.0, 1.8), 0.3);
  EXPECT_EQ(intensity, 7.0);
  const Eigen::Vector3d level = Eigen::Vector3d(1.0, 0.0, -0.02).normalized();
  EXPECT_NEAR(map.rangeFrom(sensor, level, 3.0, intensity), 20.0, 0.4);
  EXPECT_EQ(map.rangeFrom(sensor, Eigen::Vector3d::UnitZ(), 3.0, intensity), LidarRay::kNoReturn);
}

TEST(BackgroundMap, MoversAreNoBackground) {
  const VacatedBox wall{Eigen::Isometry3d(Eigen::Translation3d(20.0, 0.0, 0.0)), {2.0, 90.0, 12.0}};
  double intensity = 0.0;
  const Eigen::Vector3d level = Eigen::Vector3d(1.0, 0.0, -0.02).normalized();
  EXPECT_EQ(mapOfWall({wall}).rangeFrom({0.0, 0.0, 1.8}, level, 3.0, intensity),
            LidarRay::kNoReturn);
}

TEST(BackgroundMap, FillsThePlaceOfAVacatedVehicle) {
  const BackgroundMap map = mapOfWall({});
  const BackgroundOfSensor background(map, Eigen::Isometry3d(Eigen::Translation3d(0.0, 0.0, 1.8)));
  PosedBody car;
  car.body = lidarBodyOf(AgentClass::kCar, {4.5, 1.9, 1.5});
  car.end = Eigen::Isometry3d(Eigen::Translation3d(10.0, 0.0, -1.8));
  car.begin = car.end;
  MadeUpLidar lidar;
  lidar.columns = 360;
  PointCloud cloud = madeUpCloud(lidar, wallRange);
  const CloudLayout layout(cloud);
  editCloud(cloud, layout, raysOf(cloud, layout, kTiming), {{car}, {}, nullptr, 0.0, 1}, {});
  const CloudChange change = editCloud(cloud, layout, raysOf(cloud, layout, kTiming),
                                       {{}, {{car.end, car.body.size}}, &background, 0.0, 1}, {});
  EXPECT_GT(change.vacated, 20u);
  EXPECT_EQ(change.filled, change.vacated);
}

}  // namespace
}  // namespace forge
