#include "collision_forge/io/lidar/surface_returns.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "collision_forge/io/lidar/cloud_injection.h"
#include "io/lidar/made_up_cloud.h"

namespace forge {
namespace {

PosedBody boxAhead(double fit) {
  PosedBody body;
  body.body = lidarBodyOf(AgentClass::kStaticObject, {2.0, 2.0, 2.0});
  body.end = Eigen::Isometry3d(Eigen::Translation3d(10.0, 0.0, -1.0));
  body.begin = body.end;
  body.fit = fit;
  return body;
}

LidarRay rayTo(double y, double z) {
  LidarRay ray;
  ray.direction = Eigen::Vector3d(9.0, y, z).normalized().cast<float>();
  return ray;
}

TEST(PosedBody, TheFitShrinksTheOutlineAroundItsGroundPoint) {
  EXPECT_TRUE(boxAhead(1.0).hitOf(rayTo(0.95, 0.0)));
  EXPECT_FALSE(boxAhead(0.8).hitOf(rayTo(0.95, 0.0)));
  EXPECT_NEAR(boxAhead(0.8).hitOf(rayTo(0.0, 0.0))->distance, 9.2, 1e-6);
  EXPECT_TRUE(boxAhead(0.8).hitOf(rayTo(0.0, 0.75)));
  EXPECT_FALSE(boxAhead(0.8).hitOf(rayTo(0.0, 0.9)));
}

TEST(PosedBody, TheWindowHoldsAllHits) {
  PosedBody body = boxAhead(1.0);
  body.begin = Eigen::Isometry3d(Eigen::Translation3d(9.0, 1.0, -1.0));
  body.begin_time = -0.1;
  for (double y = -3.0; y < 4.0; y += 0.05) {
    for (double z = -2.0; z < 2.0; z += 0.05) {
      LidarRay ray = rayTo(y, z);
      for (const float time : {-0.1F, -0.05F, 0.0F}) {
        ray.time = time;
        EXPECT_TRUE(!body.hitOf(ray) || body.window().contains(ray.direction));
      }
    }
  }
  EXPECT_FALSE(body.window().contains(-Eigen::Vector3f::UnitX()));
}

TEST(SurfaceReturns, TheModelMaterialsFallsWithRangeAndGrazingIncidence) {
  const LidarBody body = boxAhead(1.0).body;
  const SurfaceReturns model;
  const auto share = [&](double distance, double incidence, SurfaceKind surface) {
    return model.shareOf(body, {distance, incidence, surface}, 0.5);
  };
  EXPECT_GT(share(10.0, 1.0, SurfaceKind::kPaint), 0.9);
  EXPECT_LT(share(10.0, 1.0, SurfaceKind::kGlass), 0.5);
  EXPECT_LT(share(60.0, 1.0, SurfaceKind::kPaint), share(10.0, 1.0, SurfaceKind::kPaint));
  EXPECT_LT(share(10.0, 0.02, SurfaceKind::kPaint), 0.3);
  EXPECT_GT(model.intensityOf(body, {10.0, 1.0, SurfaceKind::kLamp}, 0.5, 0.5),
            model.intensityOf(body, {10.0, 1.0, SurfaceKind::kTyre}, 0.5, 1.0));
}

/// Three cars of 40 returns each, with intensities `mean` + `step` times 0 or 1.
double spreadOfCars(const std::array<double, 3>& means, double step) {
  MadeUpLidar lidar;
  lidar.columns = 720;
  PointCloud cloud = madeUpCloud(lidar, groundRangeOf);
  std::vector<PosedBody> cars;
  for (const double y : {-6.0, 0.0, 6.0}) {
    PosedBody car;
    car.body = lidarBodyOf(AgentClass::kCar, {4.5, 1.9, 1.5});
    car.end = Eigen::Isometry3d(Eigen::Translation3d(9.0, y, -1.8));
    car.begin = car.end;
    cars.push_back(car);
  }
  const CloudLayout empty(cloud);
  editCloud(cloud, empty, raysOf(cloud, empty, {0.0, 0.1}), {cars, {}, nullptr, 0.0, 1}, {});
  const CloudLayout layout(cloud);
  for (std::size_t i = 0; i < cloud.pointCount(); ++i) {
    const Eigen::Vector3d point = layout.position(cloud.pointAt(i));
    const std::size_t car = point.y() < -3.0 ? 0 : point.y() < 3.0 ? 1 : 2;
    layout.intensity->set(cloud.pointAt(i), std::expm1(means[car] + step * (i % 2)));
  }
  SurfaceReturns surfaces;
  surfaces.learn(cloud, layout, raysOf(cloud, layout, {0.0, 0.1}), cars);
  return surfaces.spreadWithin(cars[0].body);
}

TEST(SurfaceReturns, TheSpreadOfIntensitiesWithinAVehicleIsLearnt) {
  EXPECT_NEAR(spreadOfCars({2.0, 2.0, 2.0}, 1.0), 1.0, 0.05) << "all vehicles are alike";
  EXPECT_NEAR(spreadOfCars({1.0, 2.0, 3.0}, 0.0), 0.05, 1e-9) << "the least";
  const double mixed = spreadOfCars({1.0, 2.0, 3.0}, 1.0);
  EXPECT_GT(mixed, 0.15);
  EXPECT_LT(mixed, 0.6);
  EXPECT_EQ(SurfaceReturns().spreadWithin(lidarBodyOf(AgentClass::kCar, {4.5, 1.9, 1.5})), 0.35);
}

}  // namespace
}  // namespace forge
