#include "collision_forge/io/lidar/cloud_injection.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "io/lidar/made_up_cloud.h"

namespace forge {
namespace {

constexpr SweepTiming kTiming{100.0, 0.1};

PosedBody carAt(double x, double y) {
  PosedBody car;
  car.body = lidarBodyOf(AgentClass::kCar, {4.5, 1.9, 1.5});
  car.end = Eigen::Isometry3d(Eigen::Translation3d(x, y, -1.8));
  car.begin = car.end;
  return car;
}

CloudChange edited(PointCloud& cloud, const CloudEdit& edit) {
  const CloudLayout layout(cloud);
  return editCloud(cloud, layout, raysOf(cloud, layout, kTiming), edit, {});
}

PointCloud ground(EmptyPoints empty = EmptyPoints::kLeftOut) {
  MadeUpLidar lidar;
  lidar.columns = 360;
  lidar.empty = empty;
  return madeUpCloud(lidar, groundRangeOf);
}

/// Mean of the coordinates of the points within the car's box.
Eigen::Vector3d middleOfReturns(const PointCloud& cloud) {
  const CloudLayout layout(cloud);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double count = 0.0;
  for (std::size_t i = 0; i < cloud.pointCount(); ++i) {
    const Eigen::Vector3d point = layout.position(cloud.pointAt(i));
    if (!(point.z() > -1.6)) continue;
    sum += point;
    count += 1.0;
  }
  return sum / count;
}

TEST(EditCloud, WithoutObjectsTheBytesStay) {
  PointCloud cloud = ground();
  const PointCloud before = cloud;
  edited(cloud, {});
  EXPECT_EQ(cloud.data, before.data);
  EXPECT_EQ(cloud.width, before.width);
}

TEST(EditCloud, TheCarIsThereAndShadowsTheGround) {
  PointCloud cloud = ground();
  const CloudChange change = edited(cloud, {{carAt(8.0, 0.0)}, {}, nullptr, 0.0, 1});
  EXPECT_GT(change.on_bodies, 50u);
  EXPECT_NEAR(middleOfReturns(cloud).x(), 6.0, 0.8);
  const CloudLayout layout(cloud);
  for (std::size_t i = 0; i < cloud.pointCount(); ++i) {
    const Eigen::Vector3d point = layout.position(cloud.pointAt(i));
    const bool is_behind = point.x() > 10.5 && point.x() < 15.0 && std::abs(point.y()) < 0.8;
    EXPECT_FALSE(is_behind) << point.transpose();
  }
}

TEST(EditCloud, TwoMillionPointsAreAnOrdinaryCloud) {
  MadeUpLidar lidar;
  lidar.rings = 128;
  lidar.step = 0.005;
  lidar.is_organised = true;
  lidar.empty = EmptyPoints::kNan;
  const auto pointsOnCar = [&](int columns) {
    lidar.columns = columns;
    PointCloud cloud = madeUpCloud(lidar, groundRangeOf);
    const std::size_t points = cloud.pointCount();
    const CloudChange change = edited(cloud, {{carAt(8.0, 3.0)}, {}, nullptr, 0.0, 1});
    EXPECT_EQ(points, std::size_t{128} * static_cast<std::size_t>(columns));
    EXPECT_EQ(cloud.pointCount(), points);
    return static_cast<double>(change.on_bodies);
  };
  const double few = pointsOnCar(1024);
  EXPECT_NEAR(pointsOnCar(16384), 16.0 * few, 0.1 * 16.0 * few);
}

TEST(EditCloud, RaysIntoTheSkyHitATallBody) {
  PointCloud cloud = ground();
  PosedBody truck = carAt(9.0, 0.0);
  truck.body = lidarBodyOf(AgentClass::kTruck, {8.0, 2.6, 3.5});
  const CloudChange change = edited(cloud, {{truck}, {}, nullptr, 0.0, 1});
  EXPECT_GT(change.added, 20u);
  double highest = -2.0;
  for (std::size_t i = 0; i < cloud.pointCount(); ++i) {
    highest = std::max(highest, CloudLayout(cloud).position(cloud.pointAt(i)).z());
  }
  EXPECT_GT(highest, 0.5);
}

TEST(EditCloud, NearerPointsStay) {
  const auto wall = [](const Eigen::Vector3d& direction) {
    return direction.x() > 0.2 ? 4.0 / direction.x() : groundRangeOf(direction);
  };
  PointCloud cloud = madeUpCloud({}, wall);
  const PointCloud before = cloud;
  const CloudChange change = edited(cloud, {{carAt(12.0, 0.0)}, {}, nullptr, 0.0, 1});
  EXPECT_EQ(change.on_bodies + change.removed, 0u);
  EXPECT_EQ(cloud.data, before.data);
}

TEST(EditCloud, TheBodyIsWhereItWasWhenTheRayPassed) {
  MadeUpLidar lidar;
  lidar.columns = 720;
  lidar.time_type = 7;
  PosedBody car = carAt(8.0, 0.0);
  car.begin = Eigen::Isometry3d(Eigen::Translation3d(10.0, 0.0, -1.8));
  car.begin_time = -0.1;
  PointCloud moving = madeUpCloud(lidar, groundRangeOf);
  edited(moving, {{car}, {}, nullptr, 0.0, 1});
  // The sensor looks ahead (azimuth 0) after 3.0 of 2 pi rad of its turn.
  PointCloud still = madeUpCloud(lidar, groundRangeOf);
  const double then = 10.0 - 2.0 * 3.0 / (2.0 * M_PI);
  edited(still, {{carAt(then, 0.0)}, {}, nullptr, 0.0, 1});
  EXPECT_NEAR(middleOfReturns(moving).x(), middleOfReturns(still).x(), 0.1);
}

TEST(EditCloud, RemovedPointsBecomeWhatTheCloudHasForNoReturn) {
  const VacatedBox box{carAt(8.0, 0.0).end, {4.5, 1.9, 1.5}};
  for (const EmptyPoints empty : {EmptyPoints::kLeftOut, EmptyPoints::kZero, EmptyPoints::kNan}) {
    PointCloud cloud = ground(empty);
    edited(cloud, {{carAt(8.0, 0.0)}, {}, nullptr, 0.0, 1});
    const std::size_t with_car = cloud.pointCount();
    const CloudChange change = edited(cloud, {{}, {box}, nullptr, 0.0, 1});
    EXPECT_GT(change.vacated, 40u);
    EXPECT_EQ(change.filled, 0u);
    EXPECT_EQ(cloud.pointCount(),
              empty == EmptyPoints::kLeftOut ? with_car - change.removed : with_car);
    const CloudLayout layout(cloud);
    for (std::size_t i = 0; i < cloud.pointCount(); ++i) {
      const Eigen::Vector3d point = layout.position(cloud.pointAt(i));
      EXPECT_FALSE((point - Eigen::Vector3d(8.0, 0.0, -1.0)).norm() < 0.7);
    }
    EXPECT_EQ(cloud.is_dense, empty != EmptyPoints::kNan);
  }
}

TEST(VacatedBox, IsWhereTheVehicleWasAtTheTimeOfTheRay) {
  VacatedBox box{carAt(8.0, 0.0).end, {4.5, 1.9, 1.5}};
  box.velocity = {10.0, 0.0, 0.0};
  const Eigen::Vector3d behind(8.0 - 4.5 / 2.0 - 0.4, 0.0, -1.0);
  EXPECT_TRUE(box.contains(behind, -0.05, 0.0, 0.2)) << "its rear was there half a metre earlier";
  EXPECT_FALSE(box.contains(behind, 0.0, 0.0, 0.2));
  EXPECT_TRUE(box.contains(behind, 0.0, 0.45, 0.2)) << "the margin";
  EXPECT_TRUE(box.contains({8.0, 0.0, -1.0}, -0.05, 0.0, 0.2));
  EXPECT_FALSE(box.contains({8.0, 0.0, -1.7}, 0.0, 0.0, 0.2)) << "below the lowest height";
  EXPECT_FALSE(box.contains({8.0, 0.0, -0.2}, 0.0, 0.0, 0.2)) << "above the roof";
}

TEST(EditCloud, ARayEndsOnTheBodyBehindARemovedVehicle) {
  PointCloud cloud = ground();
  edited(cloud, {{carAt(8.0, 0.0)}, {}, nullptr, 0.0, 1});
  const CloudEdit move{{carAt(16.0, 0.0)}, {vacatedBoxOf(carAt(8.0, 0.0))}, nullptr, 0.0, 2};
  EXPECT_GT(edited(cloud, move).on_bodies, 5u);
  const CloudLayout layout(cloud);
  for (std::size_t i = 0; i < cloud.pointCount(); ++i) {
    const Eigen::Vector3d point = layout.position(cloud.pointAt(i));
    EXPECT_FALSE(point.z() > -1.55 && point.x() < 12.0) << point.transpose();
  }
}

TEST(EditCloud, UnknownFieldsAndRingsOfAddedPointsFollowTheirRay) {
  MadeUpLidar lidar;
  lidar.has_unknown = true;
  lidar.time_type = 6;
  PointCloud cloud = madeUpCloud(lidar, groundRangeOf);
  PosedBody truck = carAt(6.0, 0.0);
  truck.body = lidarBodyOf(AgentClass::kTruck, {8.0, 2.6, 3.5});
  ASSERT_GT(edited(cloud, {{truck}, {}, nullptr, 0.0, 1}).added, 0u);
  const CloudLayout layout(cloud);
  double last = 0.0;
  for (std::size_t i = 0; i < cloud.pointCount(); ++i) {
    const std::uint8_t* point = cloud.pointAt(i);
    const double elevation = std::asin(layout.position(point).normalized().z());
    EXPECT_NEAR(elevation, lidar.lowest + lidar.step * layout.ring->get(point), 0.005);
    EXPECT_GE(layout.timeOf(point, 0.0), last - 1.2e-3);  // a column lasts 1.1 ms
    last = layout.timeOf(point, 0.0);
  }
}

TEST(EditCloud, IntensitiesAndReturnsAreLearntFromVehicles) {
  // A dark car that returns every ray, and another place.
  MadeUpLidar lidar;
  lidar.columns = 1440;
  PointCloud recorded = madeUpCloud(lidar, groundRangeOf);
  edited(recorded, {{carAt(8.0, 3.0)}, {}, nullptr, 0.0, 1});
  const CloudLayout layout(recorded);
  for (std::size_t i = 0; i < recorded.pointCount(); ++i) {
    std::uint8_t* point = recorded.pointAt(i);
    if (layout.position(point).z() > -1.6) layout.intensity->set(point, 99.0);
  }
  const SweepRays sweep = raysOf(recorded, layout, kTiming);
  SurfaceReturns surfaces;
  surfaces.learn(recorded, layout, sweep, {carAt(8.0, 3.0)});
  EXPECT_GT(surfaces.learntRays(), 100u);
  PointCloud cloud = recorded;
  editCloud(cloud, layout, sweep, {{carAt(8.0, -3.0)}, {}, nullptr, 0.0, 1}, surfaces);
  std::size_t learnt = 0;
  std::size_t all = 0;
  for (std::size_t i = 0; i < cloud.pointCount(); ++i) {
    const Eigen::Vector3d point = layout.position(cloud.pointAt(i));
    if (!(point.z() > -1.6 && point.y() < 0.0)) continue;
    ++all;
    if (layout.intensity->get(cloud.pointAt(i)) == 99.0) ++learnt;
  }
  EXPECT_GT(all, 50u);
  EXPECT_GT(learnt * 10, all * 8);
}

}  // namespace
}  // namespace forge
